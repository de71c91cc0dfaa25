// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__INBOX_HPP_
#define ROS__INBOX_HPP_

#include <memory>
#include <mutex>
#include <utility>

namespace all_kinds
{

/// Holds the latest message of a topic until the next cycle; copies refer to the same message.
template<typename Message>
class Inbox
{
public:
  using Pointer = std::unique_ptr<Message>;

  /// Store a message; the previous one is freed after the lock is released.
  void put(Pointer message) const
  {
    const std::lock_guard<std::mutex> lock(slot_->mutex);
    slot_->message.swap(message);
    slot_->is_new = true;
  }

  /// Take a new message by a swap, which frees none under the lock; return whether there was one.
  bool take(Message & destination) const
  {
    const std::lock_guard<std::mutex> lock(slot_->mutex);
    if (!slot_->is_new) {
      return false;
    }
    slot_->is_new = false;
    std::swap(destination, *slot_->message);
    return true;
  }

private:
  struct Slot
  {
    std::mutex mutex;
    Pointer message;
    bool is_new = false;
  };

  std::shared_ptr<Slot> slot_ = std::make_shared<Slot>();
};

}  // namespace all_kinds

#endif  // ROS__INBOX_HPP_
