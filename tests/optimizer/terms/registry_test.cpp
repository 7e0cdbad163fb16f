// SPDX-License-Identifier: Apache-2.0
// The table of terms: every row says what its term is about, and its unit is that of the residuals.
#include "optimizer/terms/registry.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "tests/support/term_context.hpp"

namespace legwright {
namespace {

TEST(TermRegistry, EveryRowHasWordsOfItsOwn) {
  std::set<std::string_view> names, labels, cost_labels;
  for (const TermEntry& entry : term_registry()) {
    EXPECT_FALSE(entry.name.empty());
    EXPECT_FALSE(entry.equation.empty()) << entry.name;
    EXPECT_FALSE(entry.unit.empty()) << entry.name;
    EXPECT_FALSE(entry.label.empty()) << entry.name;
    EXPECT_FALSE(entry.cost_label.empty()) << entry.name;
    EXPECT_EQ(entry.label.find('_'), std::string_view::npos) << entry.name;
    EXPECT_EQ(entry.cost_label.find('_'), std::string_view::npos) << entry.name;
    names.insert(entry.name);
    labels.insert(entry.label);
    cost_labels.insert(entry.cost_label);
  }
  EXPECT_EQ(names.size(), term_registry().size());
  EXPECT_EQ(labels.size(), term_registry().size());
  EXPECT_EQ(cost_labels.size(), term_registry().size());
}

TEST(TermRegistry, UnitsAreThoseOfTheResiduals) {
  for (const bool printed : {false, true}) {
    const test::TermSetting setting(printed);
    for (const TermEntry& entry : term_registry()) {
      const std::unique_ptr<Term> term = entry.make(setting.context());
      std::string units;  // in the order in which they come
      for (int e = 0; e < static_cast<int>(term->elements().size()); ++e)
        for (int row = 0; row < term->elements()[static_cast<std::size_t>(e)].rows; ++row) {
          const ResidualUnit unit = term->unit(e, row);
          EXPECT_GT(unit.size, 0.0) << entry.name;
          const std::string symbol(unit.symbol.empty() ? "1" : unit.symbol);
          if ((", " + units + ",").find(", " + symbol + ",") == std::string::npos)
            units += (units.empty() ? "" : ", ") + symbol;
        }
      EXPECT_EQ(units, entry.unit) << entry.name;
    }
  }
}

TEST(TermRegistry, FindsTermsByName) {
  for (const TermEntry& entry : term_registry()) EXPECT_EQ(find_term(entry.name), &entry);
  EXPECT_EQ(find_term("no such term"), nullptr);
  EXPECT_EQ(find_term(""), nullptr);
}

}  // namespace
}  // namespace legwright
