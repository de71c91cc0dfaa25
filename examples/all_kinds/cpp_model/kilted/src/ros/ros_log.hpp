// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__ROS_LOG_HPP_
#define ROS__ROS_LOG_HPP_

#include <cstddef>
#include <string>

#include "rclcpp/logger.hpp"
#include "rclcpp/logging.hpp"

#include "all_kinds/ros/logger.hpp"

namespace all_kinds
{

/// Return a logger that writes to the node's log, with the place of each line.
inline Logger make_logger(const rclcpp::Logger & logger)
{
  return Logger(
    [logger](Logger::Level level, const std::string & text, const Logger::Place & place) {
      constexpr RCUTILS_LOG_SEVERITY severities[] = {
        RCUTILS_LOG_SEVERITY_DEBUG,
        RCUTILS_LOG_SEVERITY_INFO,
        RCUTILS_LOG_SEVERITY_WARN,
        RCUTILS_LOG_SEVERITY_ERROR,
      };
      const rcutils_log_location_t location = {
        place.function, place.file, static_cast<std::size_t>(place.line)};
      const auto severity = severities[static_cast<int>(level)];
      rcutils_log(&location, severity, logger.get_name(), "%s", text.c_str());
    });
}

}  // namespace all_kinds

#endif  // ROS__ROS_LOG_HPP_
