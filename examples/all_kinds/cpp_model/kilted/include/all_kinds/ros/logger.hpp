// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ALL_KINDS__ROS__LOGGER_HPP_
#define ALL_KINDS__ROS__LOGGER_HPP_

#include <chrono>
#include <functional>
#include <limits>
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

  using Text = const std::string &;
  using Sink = std::function<void (Level, Text, const Place &)>;

  Logger() = default;

  /// Pass every text to a sink.
  explicit Logger(Sink sink)
  : sink_(std::move(sink))
  {
  }

  void debug(Text text, Place place = Place::here()) const {write(Level::debug, text, place);}
  void info(Text text, Place place = Place::here()) const {write(Level::info, text, place);}
  void warning(Text text, Place place = Place::here()) const {write(Level::warning, text, place);}
  void error(Text text, Place place = Place::here()) const {write(Level::error, text, place);}

  /// Write once; counted by the line that calls.
  void debug_once(Text text, Place at = Place::here()) const {once(Level::debug, text, at);}
  void info_once(Text text, Place at = Place::here()) const {once(Level::info, text, at);}
  void warning_once(Text text, Place at = Place::here()) const {once(Level::warning, text, at);}
  void error_once(Text text, Place at = Place::here()) const {once(Level::error, text, at);}

  /// Write at most once in that many seconds of wall time; counted by the line that calls.
  void debug_throttle(double seconds, Text text, Place place = Place::here()) const
  {
    write(Level::debug, text, place, seconds);
  }

  void info_throttle(double seconds, Text text, Place place = Place::here()) const
  {
    write(Level::info, text, place, seconds);
  }

  void warning_throttle(double seconds, Text text, Place place = Place::here()) const
  {
    write(Level::warning, text, place, seconds);
  }

  void error_throttle(double seconds, Text text, Place place = Place::here()) const
  {
    write(Level::error, text, place, seconds);
  }

private:
  /// When each line of code has written last.
  struct Throttle
  {
    std::mutex mutex;
    std::map<std::pair<std::string, int>, std::chrono::steady_clock::time_point> last;
  };

  void once(Level level, Text text, const Place & place) const
  {
    write(level, text, place, std::numeric_limits<double>::infinity());
  }

  void write(Level level, Text text, const Place & place, double pause = 0.0) const
  {
    if (sink_ && (pause <= 0.0 || is_due(place, pause))) {
      sink_(level, text, place);
    }
  }

  bool is_due(const Place & place, double pause) const
  {
    const auto now = std::chrono::steady_clock::now();
    const std::lock_guard<std::mutex> lock(throttle_->mutex);
    const auto [last, is_new] = throttle_->last.try_emplace({place.file, place.line}, now);
    if (!is_new && now - last->second < std::chrono::duration<double>(pause)) {
      return false;
    }
    last->second = now;
    return true;
  }

  Sink sink_;
  std::shared_ptr<Throttle> throttle_ = std::make_shared<Throttle>();
};

}  // namespace all_kinds

#endif  // ALL_KINDS__ROS__LOGGER_HPP_
