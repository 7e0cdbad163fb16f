// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/offered_proposals.hpp"

#include <fmt/format.h>

#include <utility>

#include "mjcf/propose/proposal_trial.hpp"

namespace legwright {

OfferedProposals::OfferedProposals(const std::string& text, std::filesystem::path file,
                                   const DesignSpace& declared)
    : text_(text), file_(std::move(file)), declared_(declared.size()) {
  for (const DesignParameter& parameter : declared.parameters) taken_.insert(parameter.name);
}

void OfferedProposals::leave_out(const std::string& name, const std::string& why) {
  left_out_.push_back(name + ": " + why);
}

void OfferedProposals::offer(const std::vector<Proposal>& ways) {
  std::string name = ways.front().name;
  for (int n = 2; taken_.count(name) > 0; ++n) {
    if (declared_ > 0) return;  // the file has it already
    name = fmt::format("{}_{}", ways.front().name, n);
  }
  std::string first_fault;
  for (Proposal way : ways) {
    way.name = name;
    const std::string fault = refusal({way});
    if (first_fault.empty()) first_fault = fault;
    if (!fault.empty()) continue;
    taken_.insert(name);
    proposals_.push_back(std::move(way));
    return;
  }
  leave_out(name, first_fault);
}

void OfferedProposals::keep_what_holds() {
  if (refusal(proposals_).empty() && unwritable(proposals_).empty()) return;
  std::vector<Proposal> kept;
  for (Proposal& proposal : proposals_) {
    kept.push_back(proposal);
    std::string fault = refusal(kept);
    if (fault.empty()) fault = unwritable(kept);
    if (!fault.empty()) {
      kept.pop_back();
      leave_out(proposal.name, fault);
    }
  }
  proposals_ = std::move(kept);
}

std::string OfferedProposals::refusal(const std::vector<Proposal>& proposals) const {
  return refusal_of(text_, file_, declared_, proposals);
}

std::string OfferedProposals::unwritable(const std::vector<Proposal>& proposals) const {
  return fault_at_bounds(text_, file_, proposals);
}

}  // namespace legwright
