// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef INBOX_HPP_
#define INBOX_HPP_

#include <memory>
#include <mutex>
#include <utility>

#include "boost/shared_ptr.hpp"

namespace all_kinds
{

/// The latest message of a topic, from its arrival to the next cycle; copies share it.
template<typename Message>
class Inbox
{
public:
  using Pointer = boost::shared_ptr<Message>;

  /// Keep a message in place of the one before.
  void put(Pointer message) const
  {
    const std::lock_guard<std::mutex> lock(slot_->mutex);
    slot_->message = std::move(message);
  }

  /// Move the message to where the logic reads it; return whether there was one.
  bool take(Message & destination) const
  {
    Pointer message;
    {
      const std::lock_guard<std::mutex> lock(slot_->mutex);
      message.swap(slot_->message);
    }
    if (!message) {
      return false;
    }
    destination = std::move(*message);
    return true;
  }

private:
  struct Slot
  {
    std::mutex mutex;
    Pointer message;
  };

  std::shared_ptr<Slot> slot_ = std::make_shared<Slot>();
};

}  // namespace all_kinds

#endif  // INBOX_HPP_
