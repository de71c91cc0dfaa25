// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__DIAGNOSTICS_HPP_
#define ROS__DIAGNOSTICS_HPP_

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "diagnostic_msgs/DiagnosticArray.h"
#include "ros/node_handle.h"
#include "ros/this_node.h"

#include "deadline.hpp"
#include "supervisor.hpp"
#include "timing.hpp"

#include "all_kinds/ros/logic_status.hpp"

namespace all_kinds
{

/// Publishes the state, rate, late and missed cycles of the node, and what its logic says, on
/// /diagnostics, once a second.
class Diagnostics
{
public:
  Diagnostics(ros::NodeHandle & node, const Supervisor & supervisor, const Loop * loop)
  : supervisor_(supervisor),
    loop_(loop),
    publisher_(node.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 10)),
    timer_(
      node.createWallTimer(
        ros::WallDuration(1.0),
        [this](const ros::WallTimerEvent &) {
          publish();
        }))
  {
  }

  /// Return where the logic says how it is.
  const std::shared_ptr<LogicStatus> & logic() const {return logic_;}

  /// Report when a topic is late.
  void watch(Deadline & deadline)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    deadlines_.push_back(&deadline);
  }

  /// Report how the node is, and what its logic says.
  void publish()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    Status status;
    status.name = ros::this_node::getName();
    auto level = Level::ok;
    status.message = supervisor_.state();
    add(status, "state", status.message);
    if (loop_) {
      const auto now = Stop::Clock::now();
      const auto cycles = loop_->cycles();
      const auto late = loop_->late();
      char rate[32];
      std::snprintf(
        rate, sizeof(rate), "%.3g",
        static_cast<double>(cycles - cycles_) / Stop::Seconds(now - time_).count());
      add(status, "rate (Hz)", rate);
      add(status, "late cycles", std::to_string(late));
      add(status, "missed cycles", std::to_string(loop_->missed()));
      if (late > late_) {
        late_until_ = now + timeouts::LATE;
      }
      if (now < late_until_) {
        level = Level::warning;
        status.message = "late cycles";
      }
      time_ = now;
      cycles_ = cycles;
      late_ = late;
    }
    for (const auto & deadline : deadlines_) {
      const auto late = deadline->complaint();
      if (!late.empty()) {
        status.message = level == Level::ok ? late : status.message + "; " + late;
        level = Level::warning;
      }
    }
    const auto failure = supervisor_.failure();
    if (!failure.empty()) {
      level = Level::error;
      status.message = failure;
      std::replace(status.message.begin(), status.message.end(), '\n', ' ');
    }
    add_logic(status, level, logic_->read());
    diagnostic_msgs::DiagnosticArray array;
    array.header.stamp = ros::Time::now();
    array.status.push_back(status);
    publisher_.publish(array);
  }

private:
  using Status = diagnostic_msgs::DiagnosticStatus;
  using Level = LogicStatus::Level;

  /// Add what the logic says; the worse level counts, with its sentences.
  static void add_logic(Status & status, Level level, const LogicStatus::Said & said)
  {
    status.hardware_id = said.hardware_id;
    if (said.level > level) {
      status.message = said.text;
    } else if (said.level == level && !said.text.empty()) {
      status.message += "; " + said.text;
    }
    const auto worst = std::max(level, said.level);
    status.level = worst == Level::ok ? Status::OK :
      worst == Level::warning ? Status::WARN : Status::ERROR;
    for (const auto & [key, value] : said.values) {
      add(status, key, value);
    }
  }

  static void add(Status & status, const std::string & key, const std::string & value)
  {
    diagnostic_msgs::KeyValue item;
    item.key = key;
    item.value = value;
    status.values.push_back(item);
  }

  std::mutex mutex_;
  const Supervisor & supervisor_;
  const Loop * loop_;
  std::vector<Deadline *> deadlines_;
  std::shared_ptr<LogicStatus> logic_ = std::make_shared<LogicStatus>();
  Stop::Clock::time_point time_ = Stop::Clock::now();
  std::uint64_t cycles_ = 0;
  std::uint64_t late_ = 0;
  Stop::Clock::time_point late_until_;
  ros::Publisher publisher_;
  ros::WallTimer timer_;
};

}  // namespace all_kinds

#endif  // ROS__DIAGNOSTICS_HPP_
