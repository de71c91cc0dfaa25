// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__PARAMETERS_HPP_
#define ROS__PARAMETERS_HPP_

#include "rcl_interfaces/msg/floating_point_range.hpp"
#include "rcl_interfaces/msg/integer_range.hpp"
#include "rcl_interfaces/msg/parameter_descriptor.hpp"

namespace all_kinds
{

/// Add the range of a parameter to its descriptor.
inline rcl_interfaces::msg::ParameterDescriptor between(
  double from,
  double to,
  rcl_interfaces::msg::ParameterDescriptor descriptor)
{
  descriptor.floating_point_range.resize(1);
  descriptor.floating_point_range[0].from_value = from;
  descriptor.floating_point_range[0].to_value = to;
  return descriptor;
}

/// Add the range of a parameter to its descriptor.
inline rcl_interfaces::msg::ParameterDescriptor between_integers(
  std::int64_t from,
  std::int64_t to,
  rcl_interfaces::msg::ParameterDescriptor descriptor)
{
  descriptor.integer_range.resize(1);
  descriptor.integer_range[0].from_value = from;
  descriptor.integer_range[0].to_value = to;
  descriptor.integer_range[0].step = 1;
  return descriptor;
}

}  // namespace all_kinds

#endif  // ROS__PARAMETERS_HPP_
