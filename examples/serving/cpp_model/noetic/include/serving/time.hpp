// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef SERVING__TIME_HPP_
#define SERVING__TIME_HPP_

#include <cstdint>

namespace serving
{

/// ROS time, real or simulated; it can be assigned to a message's stamp.
class Time
{
public:
  Time() = default;

  explicit Time(std::int64_t nanoseconds)
  : nanoseconds_(nanoseconds)
  {
  }

  std::int64_t nanoseconds() const {return nanoseconds_;}
  double seconds() const {return static_cast<double>(nanoseconds_) * 1e-9;}

  /// Convert to a stamp of ROS 2.
  template<typename Stamp, decltype(Stamp::nanosec) * = nullptr>
  operator Stamp() const
  {
    Stamp stamp;
    stamp.sec = static_cast<decltype(stamp.sec)>(nanoseconds_ / 1000000000);
    stamp.nanosec = static_cast<decltype(stamp.nanosec)>(nanoseconds_ % 1000000000);
    return stamp;
  }

  /// Convert to a stamp of ROS 1.
  template<typename Stamp, decltype(Stamp::nsec) * = nullptr>
  operator Stamp() const
  {
    Stamp stamp;
    stamp.sec = static_cast<decltype(stamp.sec)>(nanoseconds_ / 1000000000);
    stamp.nsec = static_cast<decltype(stamp.nsec)>(nanoseconds_ % 1000000000);
    return stamp;
  }

private:
  std::int64_t nanoseconds_ = 0;
};

}  // namespace serving

#endif  // SERVING__TIME_HPP_
