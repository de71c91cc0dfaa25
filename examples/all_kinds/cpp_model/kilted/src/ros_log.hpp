// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS_LOG_HPP_
#define ROS_LOG_HPP_

#include <string>

#include "rclcpp/logger.hpp"
#include "rclcpp/logging.hpp"

#include "all_kinds/logger.hpp"

namespace all_kinds
{

/// Return a logger that writes to the node's log.
inline Logger make_logger(const rclcpp::Logger & logger)
{
  return Logger(
    [logger](Logger::Level level, const std::string & text) {
      switch (level) {
        case Logger::Level::debug:
          RCLCPP_DEBUG(logger, "%s", text.c_str());
          break;
        case Logger::Level::info:
          RCLCPP_INFO(logger, "%s", text.c_str());
          break;
        case Logger::Level::warning:
          RCLCPP_WARN(logger, "%s", text.c_str());
          break;
        case Logger::Level::error:
          RCLCPP_ERROR(logger, "%s", text.c_str());
          break;
      }
    });
}

}  // namespace all_kinds

#endif  // ROS_LOG_HPP_
