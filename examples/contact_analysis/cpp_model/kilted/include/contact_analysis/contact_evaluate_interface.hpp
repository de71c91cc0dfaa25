// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

// The interface between ROS and the logic of contact_evaluate.
// Generated from contact_analysis.ros_package; change the interface there.

#ifndef CONTACT_ANALYSIS__CONTACT_EVALUATE_INTERFACE_HPP_
#define CONTACT_ANALYSIS__CONTACT_EVALUATE_INTERFACE_HPP_

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "contact_analysis/ros/goal.hpp"
#include "contact_analysis/ros/logger.hpp"
#include "contact_analysis/ros/publisher.hpp"
#include "contact_analysis/ros/time.hpp"
#include "contact_msgs/action/evaluate_contact.hpp"
#include "contact_msgs/action/learn_contact.hpp"
#include "contact_msgs/msg/point_array.hpp"
#include "contact_msgs/srv/set_string.hpp"
#include "geometry_msgs/msg/point.hpp"

namespace contact_analysis
{

/// Message, service and action types, under the same names in ROS 1 and ROS 2.
namespace contact_evaluate_types
{

using InCop = geometry_msgs::msg::Point;
using PubPlotLearnCop = contact_msgs::msg::PointArray;
using LoadService = contact_msgs::srv::SetString;
using StoreService = contact_msgs::srv::SetString;
using LearnAction = contact_msgs::action::LearnContact;
using EvaluateAction = contact_msgs::action::EvaluateContact;

}  // namespace contact_evaluate_types

/// A snapshot of the node's parameters.
struct ContactEvaluateConfig
{
  /// number of samples accumulated for learning
  std::int64_t samples = 200;

  /// Whether cop sampled should be published
  bool pub_sample = true;
};

/// The input and output messages of one cycle.
///
/// in_<topic>: the latest message received; in_<topic>_updated: whether it is new.
struct ContactEvaluateData
{
  /// Center of Pressure measured
  contact_evaluate_types::InCop in_cop;
  bool in_cop_updated = false;
};

/// What the logic can use of ROS, in any of its methods.
struct ContactEvaluatePassthrough
{
  /// The node's logger: log.debug(text), log.info, log.warning, log.error; to write once:
  /// log.info_once(text); at most every two seconds: log.info_throttle(2.0, text).
  Logger log;

  /// Returns the ROS time; it converts to a message's stamp and back.
  std::function<Time()> now = [] {return Time();};

  /// Waits that many seconds of ROS time; returns false at once when the node stops.
  std::function<bool(double)> sleep = [](double) {return true;};

  /// Stops the node with an error, as an exception would, from any thread; logs the reason.
  std::function<void(const std::string &)> fail = [](const std::string &) {};

  /// Cops defining the latest contact
  std::shared_ptr<Publisher<contact_evaluate_types::PubPlotLearnCop>> pub_plot_learn_cop =
    std::make_shared<Publisher<contact_evaluate_types::PubPlotLearnCop>>();
};

}  // namespace contact_analysis

#endif  // CONTACT_ANALYSIS__CONTACT_EVALUATE_INTERFACE_HPP_
