// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS_LOG_HPP_
#define ROS_LOG_HPP_

#include <string>

#include "ros/console.h"

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

}  // namespace serving

#endif  // ROS_LOG_HPP_
