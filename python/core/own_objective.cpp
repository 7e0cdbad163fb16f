// SPDX-License-Identifier: Apache-2.0
#include "python/core/own_objective.hpp"

#include <nanobind/eigen/dense.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <stdexcept>
#include <string>
#include <typeinfo>
#include <utility>
#include <vector>

namespace nb = nanobind;

namespace legwright {
namespace {

template <class Arrays, class Visit>
void for_each_array(Arrays& arrays, const Visit& visit) {
  visit("s", arrays.s);
  visit("joints", arrays.joints);
  visit("torques", arrays.torques);
  visit("root", arrays.root);
  visit("com", arrays.com);
  visit("feet", arrays.feet);
  visit("forces", arrays.forces);
  visit("mass", arrays.mass);
  visit("printed_volume", arrays.printed_volume);
}

/// What a task's motion always is: its name, times, contacts, joints and feet.
nb::dict about(const Objective& objective, const std::string& task) {
  const Gait& gait = objective.task().gait;
  const Layout& layout = objective.layout();
  Eigen::VectorXd time(layout.knot_count() + 1);
  Eigen::MatrixXd contact(layout.knot_count() + 1, layout.foot_count());
  for (int knot = 0; knot <= layout.knot_count(); ++knot) {
    time[knot] = knot * gait.time_step();
    for (int foot = 0; foot < layout.foot_count(); ++foot)
      contact(knot, foot) = gait.in_contact(knot, foot) ? 1.0 : 0.0;
  }
  std::vector<std::string> joints, feet;
  const Morphology& robot = objective.morphology();
  for (std::size_t i = 1; i < robot.links.size(); ++i) joints.push_back(robot.links[i].joint.name);
  for (const Foot& foot : robot.feet) feet.push_back(foot.name);
  std::vector<std::string> parameters;
  for (const DesignParameter& each : objective.space().parameters) parameters.push_back(each.name);
  nb::dict out;
  out["task"] = nb::cast(task);
  out["time"] = nb::cast(std::move(time));
  out["contact"] = nb::cast(std::move(contact));
  out["joint_names"] = nb::cast(joints);
  out["foot_names"] = nb::cast(feet);
  out["parameters"] = nb::cast(parameters);
  out["scale"] = nb::cast(objective.space().scale());
  return out;
}

/// v of one task, by asking Python.
class AskedFunction {
 public:
  AskedFunction(const nb::object& objective, std::string name, int task, Conversation& conversation,
                std::function<void(nb::python_error&&)> interrupt)
      : objective_(&objective),
        name_(std::move(name)),
        task_(task),
        conversation_(&conversation),
        interrupt_(std::move(interrupt)) {}

  double operator()(const MotionArrays& at, MotionArrays* gradient) const {
    double value = 0.0;
    std::string raised;
    const bool done = conversation_->ask([&] {
      try {
        value = call(at, gradient);
      } catch (nb::python_error& error) {
        if (!error.matches(PyExc_KeyboardInterrupt)) {
          raised = text_of(error);
          throw;
        }
        interrupt_(std::move(error));  // the run needs an answer to come to its end
        value = call(at, gradient);
      } catch (const std::bad_cast&) {  // nothing but Python's errors leaves this thread
        raised = "AskedObjective has returned what is no number or array";
        PyErr_SetString(PyExc_TypeError, raised.c_str());
        nb::raise_python_error();
      }
    });
    if (!done) throw std::runtime_error("objective " + name_ + ": " + raised);
    return value;
  }

 private:
  double call(const MotionArrays& at, MotionArrays* gradient) const {
    nb::dict arrays;
    for_each_array(at, [&](const char* key, const auto& array) {
      arrays[key] = nb::cast(array, nb::rv_policy::copy);
    });
    const nb::object answer = (*objective_)(task_, arrays, gradient != nullptr);
    const auto value = nb::cast<double>(answer[0]);
    if (gradient == nullptr) return value;
    const nb::object by_entry = answer[1];
    for_each_array(*gradient, [&](const char* key, auto& array) {
      if (by_entry.attr("get")(key).is_none()) return;
      array = nb::cast<std::decay_t<decltype(array)>>(by_entry[key]);
    });
    return value;
  }
  static std::string text_of(const nb::python_error& error) {
    return nb::cast<std::string>(error.type().attr("__name__")) + ": " +
           nb::cast<std::string>(nb::str(error.value()));
  }

  const nb::object* objective_;  // no copy: a count may only change with the lock
  std::string name_;
  int task_;
  Conversation* conversation_;
  std::function<void(nb::python_error&&)> interrupt_;
};

}  // namespace

void set_own_objective(CodesignProblem& problem, const nb::object& objective,
                       Conversation& conversation,
                       const std::function<void(nb::python_error&&)>& interrupt) {
  OwnOuter own;
  const bool begun = conversation.ask([&] {
    nb::list tasks;
    for (int k = 0; k < problem.task_count(); ++k)
      tasks.append(about(*problem.objectives[k], problem.task(k).name));
    objective.attr("begin")(tasks);
    own.name = nb::cast<std::string>(objective.attr("name"));
    own.source = nb::cast<std::string>(objective.attr("source"));
    own.unit = nb::cast<std::string>(objective.attr("unit"));
    own.weight = nb::cast<double>(objective.attr("weight"));
    own.reference = nb::cast<std::optional<double>>(objective.attr("reference"));
  });
  if (!begun) throw std::runtime_error("the objective could not be begun");
  own.functions = [&, name = own.name](int task) -> MotionQuantity {
    return AskedFunction(objective, name, task, conversation, interrupt);
  };
  set_outer(problem, own);
}

}  // namespace legwright
