#ifndef CONTRACT__ROS_PLACES_HPP_
#define CONTRACT__ROS_PLACES_HPP_

#if __has_include("rclcpp_lifecycle/lifecycle_node.hpp")

#include <dlfcn.h>

#include <cstdint>
#include <string>

#include "rcl/node.h"
#include "rcl_lifecycle/rcl_lifecycle.h"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

#include "contract/behaviour.hpp"

// Functions of ROS 2, found before its own: they do the same, and what a test tells them to.
// A moment between two threads becomes as long as the test likes.

namespace contract
{

inline void pass(const std::string & place)
{
  static const Behaviour ros("ros", {});
  ros.pass(place);
}

}  // namespace contract

/// `transition`: one begins, and its node is still in its old state.
rcl_ret_t rcl_lifecycle_trigger_transition_by_id(
  rcl_lifecycle_state_machine_t * machine, std::uint8_t id, bool is_published)
{
  contract::pass("transition");
  const auto * transition = rcl_lifecycle_get_transition_by_id(machine->current_state, id);
  const auto * label = transition ? transition->label : "";
  return rcl_lifecycle_trigger_transition_by_label(machine, label, is_published);
}

/// `leave`: the node is about to leave the graph.
rcl_ret_t rcl_node_fini(rcl_node_t * node)
{
  contract::pass("leave");
  using Function = rcl_ret_t (*)(rcl_node_t *);
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, "rcl_node_fini"))(node);
}

namespace rclcpp_lifecycle
{

/// `THREAD reads PARAMETER`: a thread has read a parameter and not used it yet.
bool LifecycleNode::get_parameter(const std::string & name, rclcpp::Parameter & parameter) const
{
  auto * node = const_cast<LifecycleNode *>(this);
  const bool is_set = node->get_node_parameters_interface()->get_parameter(name, parameter);
  contract::pass(contract::Behaviour::thread_name() + " reads " + name);
  return is_set;
}

/// `stamp`: diagnostics are about to be published.
rclcpp::Time LifecycleNode::now() const
{
  contract::pass("stamp");
  return const_cast<LifecycleNode *>(this)->get_node_clock_interface()->get_clock()->now();
}

}  // namespace rclcpp_lifecycle

#endif

#endif  // CONTRACT__ROS_PLACES_HPP_
