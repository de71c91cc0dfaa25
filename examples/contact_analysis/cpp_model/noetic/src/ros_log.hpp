// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

#ifndef ROS_LOG_HPP_
#define ROS_LOG_HPP_

#include <string>

#include "ros/console.h"

#include "contact_analysis/logger.hpp"

namespace contact_analysis
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

}  // namespace contact_analysis

#endif  // ROS_LOG_HPP_
