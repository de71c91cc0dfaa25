// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef CALLBACK_THREAD_HPP_
#define CALLBACK_THREAD_HPP_

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <thread>

#include "rclcpp/callback_group.hpp"
#include "rclcpp/executors/single_threaded_executor.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

#include "own_executor.hpp"

namespace all_kinds
{

/// A thread for one callback, so that a blocking callback delays no other.
///
/// This works with any executor.
class CallbackThread
{
public:
  using Connect = std::function<std::shared_ptr<void>(const rclcpp::CallbackGroup::SharedPtr &)>;

  /// Start a thread that spins the callback group of what `connect` creates.
  CallbackThread(rclcpp_lifecycle::LifecycleNode & node, const Connect & connect)
  : group_(make_own_group(node)),
    receiver_(connect(group_)),
    executor_(make_executor_options(node))
  {
    executor_.add_callback_group(group_, node.get_node_base_interface());
    thread_ = std::thread(
      [this] {
        executor_.spin();
        ended_ = true;
      });
  }

  /// Join the thread, after the current callback.
  ~CallbackThread()
  {
    while (!ended_) {
      // Repeatedly: a cancel before the thread spins has no effect.
      executor_.cancel();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    thread_.join();
  }

  CallbackThread(const CallbackThread &) = delete;
  CallbackThread & operator=(const CallbackThread &) = delete;

private:
  rclcpp::CallbackGroup::SharedPtr group_;
  std::shared_ptr<void> receiver_;
  rclcpp::executors::SingleThreadedExecutor executor_;
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

}  // namespace all_kinds

#endif  // CALLBACK_THREAD_HPP_
