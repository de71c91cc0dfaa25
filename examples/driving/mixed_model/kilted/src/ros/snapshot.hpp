// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__SNAPSHOT_HPP_
#define ROS__SNAPSHOT_HPP_

#include <memory>
#include <mutex>

namespace driving
{

/// A value that is replaced as a whole while other threads read it.
template<typename Value>
class Snapshot
{
public:
  std::shared_ptr<const Value> get() const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return value_;
  }

  void set(const Value & value)
  {
    auto next = std::make_shared<const Value>(value);
    const std::lock_guard<std::mutex> lock(mutex_);
    // The previous value is freed after the lock.
    value_.swap(next);
  }

private:
  mutable std::mutex mutex_;
  std::shared_ptr<const Value> value_ = std::make_shared<const Value>();
};

}  // namespace driving

#endif  // ROS__SNAPSHOT_HPP_
