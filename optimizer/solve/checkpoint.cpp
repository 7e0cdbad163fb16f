// SPDX-License-Identifier: Apache-2.0
#include "optimizer/solve/checkpoint.hpp"

namespace legwright {

void SolveState::operator()(double& member) {
  if (is_read_)
    member = numbers_.at(next_++);
  else
    numbers_.push_back(member);
}

void SolveState::operator()(int& member) {
  double value = member;
  (*this)(value);
  member = static_cast<int>(value);
}

void SolveState::operator()(bool& member) {
  double value = member ? 1.0 : 0.0;
  (*this)(value);
  member = value != 0.0;
}

void SolveState::operator()(Eigen::VectorXd& member) {
  int size = static_cast<int>(member.size());
  (*this)(size);
  if (is_read_) member.resize(size);
  for (double& entry : member) (*this)(entry);
}

void SolveState::operator()(std::vector<double>& member) {
  size_of(member);
  for (double& entry : member) (*this)(entry);
}

void SolveState::operator()(std::string& member) {
  std::vector<double> bytes;
  for (const char c : member) bytes.push_back(static_cast<unsigned char>(c));
  (*this)(bytes);
  member.clear();
  for (const double byte : bytes)
    member.push_back(static_cast<char>(static_cast<unsigned char>(byte)));
}

Checkpoint Checkpoint::in(std::string_view name) const {
  return store_ == nullptr ? Checkpoint() : Checkpoint(store_, name_ + "/" + std::string(name));
}

std::vector<double> Checkpoint::find() const {
  return store_ == nullptr ? std::vector<double>() : store_->find(name_);
}

void Checkpoint::keep_numbers(const std::vector<double>& numbers) {
  store_->keep(name_, numbers);
  since_kept_ = Stopwatch();
}

bool Checkpoint::due() const {
  return store_ != nullptr && since_kept_.seconds() >= store_->seconds_between();
}

}  // namespace legwright
