// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ALL_KINDS__LOGGER_HPP_
#define ALL_KINDS__LOGGER_HPP_

#include <functional>
#include <string>
#include <utility>

namespace all_kinds
{

/// Writes to the ROS log; without a sink, to nowhere.
class Logger
{
public:
  enum class Level {debug, info, warning, error};

  using Sink = std::function<void (Level, const std::string &)>;

  Logger() = default;

  /// Pass every text to a sink.
  explicit Logger(Sink sink)
  : sink_(std::move(sink))
  {
  }

  void debug(const std::string & text) const {write(Level::debug, text);}
  void info(const std::string & text) const {write(Level::info, text);}
  void warning(const std::string & text) const {write(Level::warning, text);}
  void error(const std::string & text) const {write(Level::error, text);}

private:
  void write(Level level, const std::string & text) const
  {
    if (sink_) {
      sink_(level, text);
    }
  }

  Sink sink_;
};

}  // namespace all_kinds

#endif  // ALL_KINDS__LOGGER_HPP_
