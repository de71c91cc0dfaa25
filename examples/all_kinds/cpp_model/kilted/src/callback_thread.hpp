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

/// A thread for one callback, so that one that blocks stops no other.
///
/// It does not matter which executor the node is added to.
class CallbackThread
{
public:
  using Connect = std::function<std::shared_ptr<void>(const rclcpp::CallbackGroup::SharedPtr &)>;

  /// Start the thread for what `connect` makes with the group it is given.
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

  /// Wait for the end of the callback, if it runs, and disconnect.
  ~CallbackThread()
  {
    while (!ended_) {
      // Again and again: one that comes before the thread spins has no effect.
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
