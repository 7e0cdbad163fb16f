// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "mjcf/propose/proposal.hpp"
#include "optimizer/design/design.hpp"

namespace legwright {

/// Proposals for a robot's file, each tried on the file itself, and what is left out.
class OfferedProposals {
 public:
  /// @param declared what the file has already, which is not proposed anew. Text must outlive this.
  OfferedProposals(const std::string& text, std::filesystem::path file,
                   const DesignSpace& declared);

  /// Takes the first of some that the file bears by itself; where it bears none, they are left out,
  /// for the reason of the first. @param ways of moving the same, all of one name
  void offer(const std::vector<Proposal>& ways);
  void leave_out(const std::string& name, const std::string& why);
  /// Each was accepted alone; together some may not be, as two stretches that are oblique. And what
  /// is proposed can be written at both bounds.
  void keep_what_holds();

  const std::vector<Proposal>& proposals() const { return proposals_; }
  const std::vector<std::string>& left_out() const { return left_out_; }  // "NAME: why"

 private:
  std::string refusal(const std::vector<Proposal>& proposals) const;
  std::string unwritable(const std::vector<Proposal>& proposals) const;

  const std::string& text_;
  const std::filesystem::path file_;
  const int declared_;
  std::set<std::string> taken_;
  std::vector<Proposal> proposals_;
  std::vector<std::string> left_out_;
};

}  // namespace legwright
