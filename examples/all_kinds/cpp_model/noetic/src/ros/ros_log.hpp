// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__ROS_LOG_HPP_
#define ROS__ROS_LOG_HPP_

#include <map>
#include <string>

#include "ros/console.h"
#include "ros/param.h"

#include "all_kinds/ros/logger.hpp"

namespace all_kinds
{

/// Write a line of a level to the ROS log.
template<ros::console::Level level>
void write_line(const std::string & text, const Logger::Place & place)
{
  ROSCONSOLE_DEFINE_LOCATION(true, level, ROSCONSOLE_DEFAULT_NAME);
  if (__rosconsole_define_location__enabled) {
    ros::console::print(
      nullptr, __rosconsole_define_location__loc.logger_, level,
      place.file, place.line, place.function, "%s", text.c_str());
  }
}

/// Write to the ROS log, with the place in the logic.
inline void write_log(Logger::Level level, const std::string & text, const Logger::Place & place)
{
  switch (level) {
    case Logger::Level::debug:
      write_line<ros::console::levels::Debug>(text, place);
      break;
    case Logger::Level::info:
      write_line<ros::console::levels::Info>(text, place);
      break;
    case Logger::Level::warning:
      write_line<ros::console::levels::Warn>(text, place);
      break;
    case Logger::Level::error:
      write_line<ros::console::levels::Error>(text, place);
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

}  // namespace all_kinds

#endif  // ROS__ROS_LOG_HPP_
