// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ALL_KINDS__ROS__TIME_HPP_
#define ALL_KINDS__ROS__TIME_HPP_

#include <chrono>
#include <cstdint>

namespace all_kinds
{

/// ROS time, real or simulated; it converts to a message's stamp and back.
///
/// The difference of two is a std::chrono duration: `now() - message.header.stamp < 100ms`.
class Time
{
public:
  using Duration = std::chrono::nanoseconds;

  Time() = default;

  explicit Time(std::int64_t nanoseconds)
  : nanoseconds_(nanoseconds)
  {
  }

  /// Convert from a message's stamp.
  template<typename Stamp, decltype(Stamp::nanosec) * = nullptr>
  Time(const Stamp & stamp)  // NOLINT(runtime/explicit)
  : nanoseconds_(stamp.sec * std::int64_t{1000000000} + stamp.nanosec)
  {
  }

  /// Convert to a message's stamp.
  template<typename Stamp, decltype(Stamp::nanosec) * = nullptr>
  operator Stamp() const
  {
    Stamp stamp;
    stamp.sec = static_cast<decltype(stamp.sec)>(nanoseconds_ / 1000000000);
    stamp.nanosec = static_cast<decltype(stamp.nanosec)>(nanoseconds_ % 1000000000);
    return stamp;
  }

  std::int64_t nanoseconds() const {return nanoseconds_;}
  double seconds() const {return static_cast<double>(nanoseconds_) * 1e-9;}

  friend Time operator+(Time time, Duration step) {return Time(time.nanoseconds_ + step.count());}
  friend Time operator-(Time time, Duration step) {return Time(time.nanoseconds_ - step.count());}
  friend Duration operator-(Time a, Time b) {return Duration(a.nanoseconds_ - b.nanoseconds_);}
  friend bool operator==(Time a, Time b) {return a.nanoseconds_ == b.nanoseconds_;}
  friend bool operator!=(Time a, Time b) {return a.nanoseconds_ != b.nanoseconds_;}
  friend bool operator<(Time a, Time b) {return a.nanoseconds_ < b.nanoseconds_;}
  friend bool operator<=(Time a, Time b) {return a.nanoseconds_ <= b.nanoseconds_;}
  friend bool operator>(Time a, Time b) {return a.nanoseconds_ > b.nanoseconds_;}
  friend bool operator>=(Time a, Time b) {return a.nanoseconds_ >= b.nanoseconds_;}

private:
  std::int64_t nanoseconds_ = 0;
};

}  // namespace all_kinds

#endif  // ALL_KINDS__ROS__TIME_HPP_
