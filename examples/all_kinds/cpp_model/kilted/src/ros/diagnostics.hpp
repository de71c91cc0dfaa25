// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__DIAGNOSTICS_HPP_
#define ROS__DIAGNOSTICS_HPP_

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "diagnostic_msgs/msg/diagnostic_array.hpp"
#include "diagnostic_msgs/msg/diagnostic_status.hpp"
#include "diagnostic_msgs/msg/key_value.hpp"

#include "deadline.hpp"
#include "managed_node.hpp"
#include "timing.hpp"

#include "all_kinds/ros/logic_status.hpp"

namespace all_kinds
{

/// Publishes the state, rate, late and missed cycles of a node, and what its logic says, on
/// /diagnostics, once a second.
class Diagnostics
{
public:
  /// Without a loop, report the state alone.
  explicit Diagnostics(
    ManagedNode & node,
    const std::shared_ptr<const Loop> & loop = nullptr)
  : node_(node),
    loop_(loop),
    publisher_(rclcpp::create_publisher<diagnostic_msgs::msg::DiagnosticArray>(
        node, "/diagnostics", 10)),
    timer_(
      node.create_wall_timer(
        std::chrono::seconds(1),
        [this, life = life_] {
          const std::lock_guard<std::mutex> lock(life->mutex);
          if (!life->has_ended) {
            publish();
          }
        }))
  {
  }

  /// Return the status of a new logic, reported as long as the logic keeps it.
  std::shared_ptr<LogicStatus> renew()
  {
    const std::lock_guard<std::mutex> lock(life_->mutex);
    const auto status = std::make_shared<LogicStatus>();
    logic_ = status;
    return status;
  }

  /// From now on report the topics that are late by these deadlines.
  void watch(const std::vector<std::shared_ptr<Deadline>> & deadlines)
  {
    const std::lock_guard<std::mutex> lock(life_->mutex);
    deadlines_ = deadlines;
  }

  /// Report at once, and wait until that has been received, as the process may end soon.
  void report()
  {
    {
      const std::lock_guard<std::mutex> lock(life_->mutex);
      publish();
    }
    publisher_->wait_for_all_acked(timeouts::RECEIVE);
  }

  /// Wait for a report that is being published in another thread.
  ~Diagnostics()
  {
    const std::lock_guard<std::mutex> lock(life_->mutex);
    life_->has_ended = true;
  }

  Diagnostics(const Diagnostics &) = delete;
  Diagnostics & operator=(const Diagnostics &) = delete;

private:
  using Status = diagnostic_msgs::msg::DiagnosticStatus;
  using Level = LogicStatus::Level;

  /// Outlives the timer, which an executor may hold for longer.
  struct Life
  {
    std::mutex mutex;
    bool has_ended = false;
  };

  void publish()
  {
    Status status;
    status.name = node_.get_node_base_interface()->get_fully_qualified_name();
    auto level = Level::ok;
    status.message = node_.get_current_state().label();
    add(status, "state", status.message);
    if (loop_) {
      add_cycles(status);
      if (std::chrono::steady_clock::now() < late_until_) {
        level = Level::warning;
        status.message = "late cycles";
      }
    }
    for (const auto & deadline : deadlines_) {
      const auto late = deadline->complaint();
      if (!late.empty()) {
        status.message = level == Level::ok ? late : status.message + "; " + late;
        level = Level::warning;
      }
    }
    const auto failure = node_.calls()->failure();
    if (!failure.empty()) {
      level = Level::error;
      status.message = failure;
      std::replace(status.message.begin(), status.message.end(), '\n', ' ');
    }
    const auto logic = logic_.lock();
    add_logic(status, level, logic ? logic->read() : LogicStatus::Said());
    diagnostic_msgs::msg::DiagnosticArray message;
    message.header.stamp = node_.now();
    message.status.push_back(status);
    publisher_->publish(message);
  }

  void add_cycles(Status & status)
  {
    const auto cycles = loop_->cycles();
    const auto late = loop_->late();
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> elapsed = now - last_time_;
    char rate[32];
    std::snprintf(
      rate, sizeof(rate), "%.3g", static_cast<double>(cycles - last_cycles_) / elapsed.count());
    add(status, "rate (Hz)", rate);
    add(status, "late cycles", std::to_string(late));
    add(status, "missed cycles", std::to_string(loop_->missed()));
    if (late > last_late_) {
      late_until_ = now + timeouts::LATE;
    }
    last_time_ = now;
    last_cycles_ = cycles;
    last_late_ = late;
  }

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
    diagnostic_msgs::msg::KeyValue item;
    item.key = key;
    item.value = value;
    status.values.push_back(item);
  }

  std::shared_ptr<Life> life_ = std::make_shared<Life>();
  ManagedNode & node_;
  std::weak_ptr<LogicStatus> logic_;
  std::vector<std::shared_ptr<Deadline>> deadlines_;
  std::shared_ptr<const Loop> loop_;
  std::shared_ptr<rclcpp::Publisher<diagnostic_msgs::msg::DiagnosticArray>> publisher_;
  std::chrono::steady_clock::time_point last_time_ = std::chrono::steady_clock::now();
  std::uint64_t last_cycles_ = 0;
  std::uint64_t last_late_ = 0;
  std::chrono::steady_clock::time_point late_until_;
  rclcpp::TimerBase::SharedPtr timer_;
};

}  // namespace all_kinds

#endif  // ROS__DIAGNOSTICS_HPP_
