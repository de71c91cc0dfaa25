// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__PARAMETERS_HPP_
#define ROS__PARAMETERS_HPP_

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "ros/node_handle.h"
#include "xmlrpcpp/XmlRpcValue.h"

namespace all_kinds
{

// roscpp 1.15 rounds a double where an int is asked for.
inline bool read_integer(const XmlRpc::XmlRpcValue & found, std::int64_t & value)
{
  const bool is_integer = found.getType() == XmlRpc::XmlRpcValue::TypeInt;
  if (is_integer) {
    value = static_cast<int>(XmlRpc::XmlRpcValue(found));
  }
  return is_integer;
}

inline bool get_parameter(
  const ros::NodeHandle & node,
  const std::string & name,
  std::int64_t & value)
{
  XmlRpc::XmlRpcValue found;
  return node.getParam(name, found) && read_integer(found, value);
}

inline bool get_parameter(
  const ros::NodeHandle & node,
  const std::string & name,
  std::vector<std::int64_t> & values)
{
  XmlRpc::XmlRpcValue found;
  if (!node.getParam(name, found) || found.getType() != XmlRpc::XmlRpcValue::TypeArray) {
    return false;
  }
  values.resize(static_cast<std::size_t>(found.size()));
  for (int i = 0; i < found.size(); ++i) {
    if (!read_integer(found[i], values[static_cast<std::size_t>(i)])) {
      return false;
    }
  }
  return true;
}

template<typename Value>
bool get_parameter(const ros::NodeHandle & node, const std::string & name, Value & value)
{
  return node.getParam(name, value);
}

/// Read a parameter of a node; without one, keep the value.
template<typename Value>
void read_parameter(const ros::NodeHandle & node, const std::string & name, Value & value)
{
  // Twice, as a signal makes a call of roscpp 1.15 to the master fail.
  const auto is_read = [&] {return get_parameter(node, name, value);};
  if (node.hasParam(name) && !is_read() && !is_read()) {
    throw std::runtime_error("Parameter " + node.resolveName(name) + " has a wrong type.");
  }
}

}  // namespace all_kinds

#endif  // ROS__PARAMETERS_HPP_
