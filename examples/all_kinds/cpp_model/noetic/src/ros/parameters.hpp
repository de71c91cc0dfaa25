// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__PARAMETERS_HPP_
#define ROS__PARAMETERS_HPP_

#include <cstdint>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "ros/names.h"
#include "ros/node_handle.h"
#include "xmlrpcpp/XmlRpcValue.h"

namespace all_kinds
{

// roscpp 1.15 rounds a double where an int is asked for, and converts the numbers of a list.
inline bool convert(XmlRpc::XmlRpcValue & found, bool & value)
{
  const bool fits = found.getType() == XmlRpc::XmlRpcValue::TypeBoolean;
  value = fits && static_cast<bool &>(found);
  return fits;
}

inline bool convert(XmlRpc::XmlRpcValue & found, std::int64_t & value)
{
  const bool fits = found.getType() == XmlRpc::XmlRpcValue::TypeInt;
  value = fits ? static_cast<int &>(found) : 0;
  return fits;
}

inline bool convert(XmlRpc::XmlRpcValue & found, double & value)
{
  if (found.getType() == XmlRpc::XmlRpcValue::TypeInt) {
    value = static_cast<int &>(found);
    return true;
  }
  const bool fits = found.getType() == XmlRpc::XmlRpcValue::TypeDouble;
  value = fits ? static_cast<double &>(found) : 0.0;
  return fits;
}

inline bool convert(XmlRpc::XmlRpcValue & found, std::string & value)
{
  const bool fits = found.getType() == XmlRpc::XmlRpcValue::TypeString;
  value = fits ? static_cast<std::string &>(found) : "";
  return fits;
}

template<typename Item>
bool convert(XmlRpc::XmlRpcValue & found, std::vector<Item> & values)
{
  if (found.getType() != XmlRpc::XmlRpcValue::TypeArray) {
    return false;
  }
  values.clear();
  for (int i = 0; i < found.size(); ++i) {
    Item item;
    if (!convert(found[i], item)) {
      return false;
    }
    values.push_back(item);
  }
  return true;
}

/// Read a parameter of a node; without one, keep the value.
template<typename Value>
void read_parameter(const ros::NodeHandle & node, const std::string & name, Value & value)
{
  XmlRpc::XmlRpcValue found;
  const auto is_read = [&] {return node.getParam(name, found) && convert(found, value);};
  // Twice, as a signal makes a call of roscpp 1.15 to the master fail.
  if (node.hasParam(name) && !is_read() && !is_read()) {
    throw std::runtime_error("Parameter " + node.resolveName(name) + " has a wrong type.");
  }
}

/// Throw if the value of a parameter is not the name of a topic.
inline void check_topic(const std::string & name, const std::string & value)
{
  std::string error;
  if (value.empty() || !ros::names::validate(value, error)) {
    const auto text = "Parameter " + name + " must be the name of a topic, not '" + value + "'.";
    throw std::runtime_error(text);
  }
}

/// Throw if not all values of a parameter are names of topics, each once.
inline void check_topics(const std::string & name, const std::vector<std::string> & values)
{
  const std::string wanted = "have names of topics, each once";
  std::set<std::string> topics;
  for (const auto & value : values) {
    std::string error;
    const bool is_name = !value.empty() && ros::names::validate(value, error);
    if (!topics.insert(value).second || !is_name) {
      const std::string found = "'" + value + (is_name ? "' twice" : "'");
      throw std::runtime_error("Parameter " + name + " must " + wanted + ", not " + found + ".");
    }
  }
}

/// Throw if a parameter is out of its range, or not finite.
template<typename Number>
void check_range(const std::string & name, Number value, Number low, Number high)
{
  if (!(low <= value && value <= high)) {
    std::ostringstream text;
    text << "Parameter " << name << " must be from " << low << " to " << high << ", not " << value;
    throw std::runtime_error(text.str());
  }
}

}  // namespace all_kinds

#endif  // ROS__PARAMETERS_HPP_
