// SPDX-License-Identifier: Apache-2.0
#include "optimizer/objective/linear_rows.hpp"

namespace legwright {

LinearRows linear_rows(const Term& term, const std::vector<PlannedElement>& elements) {
  LinearRows out;
  Eigen::VectorXd offset;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const std::size_t before = out.entries.size();
    const Element& element = term.elements()[e];
    const Eigen::MatrixXd* J = term.constant_jacobian(static_cast<int>(e));
    if (J == nullptr) return {};
    offset.resize(element.rows);
    term.residual(static_cast<int>(e), Eigen::VectorXd::Zero(J->cols()), offset);
    for (int row = 0; row < J->rows(); ++row) {
      for (int k = 0; k < J->cols(); ++k)
        if ((*J)(row, k) != 0.0)
          out.entries.push_back({element.slots[static_cast<std::size_t>(k)], (*J)(row, k)});
      out.ends.push_back(static_cast<int>(out.entries.size()));
      out.offsets.push_back(offset[row]);
    }
    out.last_rows.push_back(static_cast<int>(out.ends.size()));
    out.constant.push_back(elements[e].constant ? 1 : 0);
    const ElementPlan& plan = *elements[e].plan;
    const bool lone = plan.through.empty() && plan.clique->slots.size() == 1 &&
                      !plan.reaches_design() &&
                      out.entries.size() == before + static_cast<std::size_t>(element.rows);
    out.lone.push_back(lone ? 1 : 0);
  }
  return out;
}

}  // namespace legwright
