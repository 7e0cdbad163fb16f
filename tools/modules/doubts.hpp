// SPDX-License-Identifier: Apache-2.0
// What a file says that can be and is hardly meant: figures in another unit.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <toml++/toml.h>

namespace legwright {

inline constexpr double kLeastTrunkDensity = 10.0;  // [kg/m3] of boxes that hold the rest; 260

/// Gathers what is doubtful about a file, with file, line and key.
class Doubts {
 public:
  /// @param toml of the file; it must outlive this
  Doubts(const toml::table& toml, const std::filesystem::path& file) : toml_(toml), file_(file) {}

  /// @param place of the value: `limb[0].joint[1].offset`
  void add(const std::string& place, const std::string& message);
  /// Of angles of more than a turn, which may be meant in degrees. Nothing where there is no value.
  void check_angles(const std::string& place);
  /// Of a body that is heavier than metal, or lighter than foam.
  /// @param mass_place of its mass. @param size_place of its lengths. @param least [kg/m3]
  void check_density(double mass, double volume, double least, const std::string& mass_place,
                     const std::string& size_place);
  const std::vector<std::string>& all() const { return all_; }

 private:
  const toml::table& toml_;
  const std::filesystem::path file_;
  std::vector<std::string> all_;
};

/// Three digits, and all before the point.
std::string figure_text(double value);

/// `[0, 0, -0.045]`
std::string vector_text(const Eigen::Ref<const Eigen::VectorXd>& values);

/// The vectors that may be meant by one that is too long: with a digit less, in centimetres, in
/// millimetres. Empty where none fits.
/// @param fits whether a vector [m] could be meant
std::string shorter_vectors(const Eigen::Vector3d& given,
                            const std::function<bool(const Eigen::Vector3d&)>& fits);

}  // namespace legwright
