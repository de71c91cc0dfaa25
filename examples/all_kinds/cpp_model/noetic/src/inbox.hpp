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

/// Holds the latest message of a topic until the next cycle; copies share it.
template<typename Message>
class Inbox
{
public:
  using Pointer = boost::shared_ptr<Message>;

  /// Store a message, replacing the previous one.
  void put(Pointer message) const
  {
    const std::lock_guard<std::mutex> lock(slot_->mutex);
    slot_->message = std::move(message);
  }

  /// Move the message into the data of the cycle; return whether there was one.
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
