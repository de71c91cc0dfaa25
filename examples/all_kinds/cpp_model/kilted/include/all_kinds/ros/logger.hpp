// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ALL_KINDS__ROS__LOGGER_HPP_
#define ALL_KINDS__ROS__LOGGER_HPP_

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace all_kinds
{

/// Writes to the ROS log; without a sink, to nowhere.
class Logger
{
public:
  enum class Level {debug, info, warning, error};

  /// Where a line of the log is written; as a default argument, where the function is called.
  struct Place
  {
    static constexpr Place here(
      const char * file = __builtin_FILE(),
      const char * function = __builtin_FUNCTION(),
      int line = __builtin_LINE())
    {
      return {file, function, line};
    }

    const char * file;
    const char * function;
    int line;
  };

  using Sink = std::function<void (Level, const std::string &, const Place &)>;

  Logger() = default;

  /// Pass every text to a sink.
  explicit Logger(Sink sink)
  : sink_(std::move(sink))
  {
  }

  void debug(const std::string & text, const Place & place = Place::here()) const
  {
    write(Level::debug, text, place);
  }

  void info(const std::string & text, const Place & place = Place::here()) const
  {
    write(Level::info, text, place);
  }

  void warning(const std::string & text, const Place & place = Place::here()) const
  {
    write(Level::warning, text, place);
  }

  void error(const std::string & text, const Place & place = Place::here()) const
  {
    write(Level::error, text, place);
  }

  /// Write at most once in that many seconds of wall time; every line of code counts by itself.
  void debug_throttle(
    double seconds, const std::string & text, const Place & place = Place::here()) const
  {
    if (throttle_->is_due(seconds, place)) {
      write(Level::debug, text, place);
    }
  }

  void info_throttle(
    double seconds, const std::string & text, const Place & place = Place::here()) const
  {
    if (throttle_->is_due(seconds, place)) {
      write(Level::info, text, place);
    }
  }

  void warning_throttle(
    double seconds, const std::string & text, const Place & place = Place::here()) const
  {
    if (throttle_->is_due(seconds, place)) {
      write(Level::warning, text, place);
    }
  }

  void error_throttle(
    double seconds, const std::string & text, const Place & place = Place::here()) const
  {
    if (throttle_->is_due(seconds, place)) {
      write(Level::error, text, place);
    }
  }

private:
  /// When each place has written last; thread-safe.
  class Throttle
  {
public:
    bool is_due(double seconds, const Place & place)
    {
      const auto now = std::chrono::steady_clock::now();
      const std::lock_guard<std::mutex> lock(mutex_);
      const auto [last, is_new] = last_.try_emplace({place.file, place.line}, now);
      if (!is_new && now - last->second < std::chrono::duration<double>(seconds)) {
        return false;
      }
      last->second = now;
      return true;
    }

private:
    std::mutex mutex_;
    std::map<std::pair<std::string, int>, std::chrono::steady_clock::time_point> last_;
  };

  void write(Level level, const std::string & text, const Place & place) const
  {
    if (sink_) {
      sink_(level, text, place);
    }
  }

  Sink sink_;
  std::shared_ptr<Throttle> throttle_ = std::make_shared<Throttle>();
};

}  // namespace all_kinds

#endif  // ALL_KINDS__ROS__LOGGER_HPP_
