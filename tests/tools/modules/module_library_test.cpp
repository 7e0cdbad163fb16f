// SPDX-License-Identifier: Apache-2.0
#include "tools/modules/module_library.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "mjcf/text/input_error.hpp"
#include "tests/support/source_tree.hpp"
#include "tests/tools/files/temporary_folder.hpp"
#include "tests/tools/modules/servo_text.hpp"
#include "tools/files/atomic_file.hpp"
#include "tools/files/io_error.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// Not a constant, which might be made before kSource is.
fs::path library_folder() { return test::kSource / "modules"; }
constexpr double kWater = 1000.0, kIron = 7900.0;  // [kg/m3]

/// Whether an attachment is on the surface of a module's outline.
bool lies_on(const Attachment& at, const Module& module) {
  constexpr double kNear = 1e-6;  // [m]
  const auto inside = [&](const Eigen::Vector3d& place) {
    return std::any_of(
        module.outline.begin(), module.outline.end(), [&](const OutlineShape& shape) {
          const Eigen::Vector3d own = shape.pose().inverse() * place, half = shape.half();
          const bool in_box = (own.cwiseAbs() - half).maxCoeff() <= 0.0;
          const bool is_round = shape.type == OutlineShape::Type::cylinder;
          return in_box && (!is_round || own.head<2>().norm() <= half.x());
        });
  };
  return inside(at.position - kNear * at.normal) && !inside(at.position + kNear * at.normal);
}

/// The library is read whole, so each of its figures has a source or an assumption.
TEST(InstalledModules, AreReadAndServosHaveSources) {
  const ModuleLibrary library({library_folder()});
  std::size_t servos = 0, kinds[kModuleKinds.size()] = {};
  for (const ModuleFile& file : library.modules()) {
    ++kinds[static_cast<std::size_t>(file.module.kind)];
    if (file.module.kind != ModuleKind::servo) continue;
    ++servos;
    for (const char* figure : {"mass", "outline", "joint.stall_torque"})
      EXPECT_GE(file.source_count(figure), 1u) << file.module.name << ' ' << figure;
    for (const FigureSource& source : file.sources)
      EXPECT_TRUE(source.address.starts_with("https://")) << file.module.name;
  }
  EXPECT_GE(servos, 12u);
  for (std::size_t kind = 0; kind < kModuleKinds.size(); ++kind)
    EXPECT_GE(kinds[kind], 1u) << kModuleKinds[kind];
  EXPECT_GE(kinds[static_cast<std::size_t>(ModuleKind::trunk)], 2u);
}

/// A link ends at what faces the horn before: round joints have attachments on their mantle, too.
TEST(InstalledModules, ServosCanBeHeldFromAllSidesButTheHorns) {
  const ModuleLibrary library({library_folder()});
  for (const ModuleFile& file : library.modules()) {
    const Module& module = file.module;
    if (module.kind != ModuleKind::servo) continue;
    const auto faces = [&](const Eigen::Vector3d& way) {
      return std::any_of(module.attachments.begin(), module.attachments.end(),
                         [&](const Attachment& at) {
                           return !at.on_horn && at.normal.dot(way) > 0.99 && lies_on(at, module);
                         });
    };
    for (const Eigen::Vector3d& way : {Eigen::Vector3d(-1, 0, 0), Eigen::Vector3d(1, 0, 0),
                                       Eigen::Vector3d(0, -1, 0), Eigen::Vector3d(0, 0, -1)})
      EXPECT_TRUE(faces(way)) << module.name << ", towards " << way.transpose();
  }
}

/// A slip of a unit would show: servos are neither foam nor lead, and no stronger than they weigh.
TEST(InstalledModules, FiguresAreOfTheirOrder) {
  const ModuleLibrary library({library_folder()});
  for (const ModuleFile& file : library.modules()) {
    const Module& module = file.module;
    double volume = 0.0;
    for (const OutlineShape& shape : module.outline) volume += shape.volume();
    const double density = module.mass / volume;
    EXPECT_GT(density, 0.4 * kWater) << module.name;
    EXPECT_LT(density, kIron) << module.name;
    if (!module.joint) continue;
    const double torque_density = module.joint->stall_torque / module.mass;  // [N m/kg]
    EXPECT_GT(torque_density, 10.0) << module.name;
    EXPECT_LT(torque_density, 100.0) << module.name;
    if (module.joint->no_load_speed) {
      EXPECT_GT(*module.joint->no_load_speed, 2.0) << module.name;
      EXPECT_LT(*module.joint->no_load_speed, 100.0) << module.name;
    }
    // The output leaves through the outline.
    const auto holds = [&](const OutlineShape& shape) {
      const Eigen::Vector3d at = shape.pose().inverse() * module.joint->position;
      return ((at.cwiseAbs() - shape.half()).array() < 1e-9).all();
    };
    EXPECT_TRUE(std::any_of(module.outline.begin(), module.outline.end(), holds)) << module.name;
  }
}

TEST(ModuleLibrary, AUsersModuleTakesThePlaceOfAnother) {
  const test::TemporaryFolder folder;
  std::string text = test::kWholeServo;
  text.replace(text.find("HS-1"), 4, "xl430-w250");
  write_file(folder.path() / "mine.toml", text);
  const ModuleLibrary library({library_folder(), folder.path()});
  EXPECT_EQ(library.modules().size(), ModuleLibrary({library_folder()}).modules().size());
  EXPECT_EQ(library.find("XL430-W250").module.maker, "somebody") << "whatever the case";
}

TEST(ModuleLibrary, TeachesWhereThereIsNone) {
  const ModuleLibrary library({library_folder()});
  try {
    (void)library.find("XL430-W25");
    FAIL();
  } catch (const InputError& error) {
    const std::string told = error.what();
    EXPECT_NE(told.find("did you mean 'XL430-W250'?"), std::string::npos) << told;
  }
  EXPECT_EQ(library.find_or_null("none"), nullptr);
  const test::TemporaryFolder folder;
  EXPECT_THROW(ModuleLibrary({folder.path() / "gone"}), IoError);
  EXPECT_THROW(ModuleLibrary({folder.path()}), IoError) << "holds none";
  write_file(folder.path() / "a.toml", test::kWholeServo);
  EXPECT_NO_THROW(ModuleLibrary({folder.path()}));
  write_file(folder.path() / "b.toml", test::kWholeServo);
  try {
    ModuleLibrary({folder.path()});
    FAIL() << "two of one name";
  } catch (const InputError& error) {
    const std::string told = error.what();
    const std::string other = (folder.path() / "a.toml").string();
    EXPECT_NE(told.find("b.toml:1: name: is \"HS-1\", which " + other + " has, too"),
              std::string::npos)
        << told;
  }
}

TEST(ModuleLibrary, PassesOverRobotsThatLieBesideModules) {
  const test::TemporaryFolder folder;
  write_file(folder.path() / "dog.toml", "servo = \"HS-1\"\n[trunk]\nmass = 1.0\n");
  EXPECT_THROW(ModuleLibrary({folder.path()}), IoError) << "no module";
  write_file(folder.path() / "hs1.toml", test::kWholeServo);
  write_file(folder.path() / "legs.toml", "[[limb]]\nname = \"F\"\n");
  write_file(folder.path() / "walk.toml", "robot = \"dog.xml\"\n");
  write_file(folder.path() / "trot.toml", "[gait]\nname = \"trot\"\n");
  write_file(folder.path() / "study.toml", "[base]\ngait.name = \"trot\"\n[grid]\na = [1]\n");
  EXPECT_EQ(ModuleLibrary({folder.path()}).names(), std::vector<std::string>{"HS-1"});
}

TEST(ModuleLibrary, NamesAFileThatIsNoModuleInOneLine) {
  const test::TemporaryFolder folder;
  write_file(folder.path() / "pyproject.toml", "[project]\nname = \"walk\"\n[joint]\nkp = 1\n");
  try {
    ModuleLibrary({folder.path()});
    FAIL();
  } catch (const InputError& error) {
    const std::string told = error.what();
    EXPECT_NE(told.find("pyproject.toml: kind: is missing, so this is no module"),
              std::string::npos)
        << told;
    EXPECT_EQ(told.find('\n'), std::string::npos) << told;
  }
}

}  // namespace
}  // namespace legwright
