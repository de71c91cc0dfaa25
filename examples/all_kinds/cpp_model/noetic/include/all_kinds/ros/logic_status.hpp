// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ALL_KINDS__ROS__LOGIC_STATUS_HPP_
#define ALL_KINDS__ROS__LOGIC_STATUS_HPP_

#include <map>
#include <mutex>
#include <sstream>
#include <string>
#include <type_traits>

namespace all_kinds
{

/// What the logic says of itself on /diagnostics; thread-safe.
class LogicStatus
{
public:
  /// Set a value, a number or a text, which is published as text.
  template<typename Value>
  void set(const std::string & key, const Value & value)
  {
    std::ostringstream text;
    if constexpr (std::is_same_v<Value, bool>) {
      text << (value ? "True" : "False");
    } else if constexpr (std::is_arithmetic_v<Value>) {
      text << +value;
    } else {
      text << value;
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    said_.values[key] = text.str();
  }

  /// Say that all is well, until something else is said.
  void ok(const std::string & text = "") {say(Level::ok, text);}

  /// Say what is not as it should be, until something else is said.
  void warning(const std::string & text) {say(Level::warning, text);}

  /// Say what does not work, until something else is said.
  void error(const std::string & text) {say(Level::error, text);}

  /// Say which hardware it is, such as by its serial number.
  void set_hardware_id(const std::string & hardware_id)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    said_.hardware_id = hardware_id;
  }

  enum class Level {ok, warning, error};

  /// All that is said at one time.
  struct Said
  {
    Level level = Level::ok;
    std::string text;
    std::string hardware_id = "none";
    std::map<std::string, std::string> values;
  };

  /// Return all that is said, for the node and for tests.
  Said read() const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return said_;
  }

private:
  void say(Level level, const std::string & text)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    said_.level = level;
    said_.text = text;
  }

  mutable std::mutex mutex_;
  Said said_;
};

}  // namespace all_kinds

#endif  // ALL_KINDS__ROS__LOGIC_STATUS_HPP_
