// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS_LOG_HPP_
#define ROS_LOG_HPP_

#include <map>
#include <string>

#include "ros/console.h"
#include "ros/param.h"

#include "serving/logger.hpp"

namespace serving
{

/// Write to the ROS log.
inline void write_log(Logger::Level level, const std::string & text)
{
  switch (level) {
    case Logger::Level::debug:
      ROS_DEBUG("%s", text.c_str());
      break;
    case Logger::Level::info:
      ROS_INFO("%s", text.c_str());
      break;
    case Logger::Level::warning:
      ROS_WARN("%s", text.c_str());
      break;
    case Logger::Level::error:
      ROS_ERROR("%s", text.c_str());
      break;
  }
}

/// Apply the private parameter `log_level`: debug, info, warn, error or fatal.
inline void set_log_level()
{
  const std::map<std::string, ros::console::Level> levels = {
    {"debug", ros::console::levels::Debug},
    {"info", ros::console::levels::Info},
    {"warn", ros::console::levels::Warn},
    {"error", ros::console::levels::Error},
    {"fatal", ros::console::levels::Fatal},
  };
  const auto level = levels.find(ros::param::param<std::string>("~log_level", "info"));
  if (level == levels.end()) {
    ROS_WARN("log_level must be debug, info, warn, error or fatal.");
  } else if (ros::console::set_logger_level(ROSCONSOLE_DEFAULT_NAME, level->second)) {
    ros::console::notifyLoggerLevelsChanged();
  }
}

}  // namespace serving

#endif  // ROS_LOG_HPP_
