// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__PARAMETERS_HPP_
#define ROS__PARAMETERS_HPP_

#include <type_traits>

#include "rcl_interfaces/msg/floating_point_range.hpp"
#include "rcl_interfaces/msg/integer_range.hpp"
#include "rcl_interfaces/msg/parameter_descriptor.hpp"

namespace all_kinds
{

/// Add the range of a parameter to its descriptor.
template<typename Number>
rcl_interfaces::msg::ParameterDescriptor between(
  Number from,
  Number to,
  rcl_interfaces::msg::ParameterDescriptor descriptor)
{
  if constexpr (std::is_floating_point_v<Number>) {
    rcl_interfaces::msg::FloatingPointRange range;
    range.from_value = from;
    range.to_value = to;
    descriptor.floating_point_range.push_back(range);
  } else {
    rcl_interfaces::msg::IntegerRange range;
    range.from_value = from;
    range.to_value = to;
    range.step = 1;
    descriptor.integer_range.push_back(range);
  }
  return descriptor;
}

}  // namespace all_kinds

#endif  // ROS__PARAMETERS_HPP_
