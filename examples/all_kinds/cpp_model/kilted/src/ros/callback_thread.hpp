// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__CALLBACK_THREAD_HPP_
#define ROS__CALLBACK_THREAD_HPP_

#include <exception>
#include <future>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "rclcpp/callback_group.hpp"
#include "rclcpp/executors/single_threaded_executor.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

#include "stop.hpp"

namespace all_kinds
{

/// A thread that spins a callback group of its own, so that it waits for no other callback.
///
/// This works with any executor.
class CallbackThread
{
public:
  CallbackThread(rclcpp_lifecycle::LifecycleNode & node, const std::string & name)
  : spinner_(std::make_shared<Spinner>(node))
  {
    std::packaged_task<void()> spin(
      [spinner = spinner_, name, logger = node.get_logger()] {
        name_this_thread(name);
        while (!spinner->spin(name, logger)) {
          std::this_thread::sleep_for(timeouts::RETURN);
        }
      });
    ended_ = spin.get_future();
    thread_ = std::thread(std::move(spin));
  }

  /// Join the thread, or leave it to itself if its callback does not return.
  ~CallbackThread()
  {
    const auto end = Stop::deadline(timeouts::CALLBACK);
    auto status = std::future_status::timeout;
    while (status != std::future_status::ready && Stop::Clock::now() < end) {
      // Repeated, as Executor::cancel of rclcpp 29.3 has no effect before `spin` has begun.
      spinner_->executor.cancel();
      status = ended_.wait_for(timeouts::SETTLE);
    }
    if (status == std::future_status::ready) {
      thread_.join();
    } else {
      thread_.detach();
    }
  }

  CallbackThread(const CallbackThread &) = delete;
  CallbackThread & operator=(const CallbackThread &) = delete;

  const rclcpp::CallbackGroup::SharedPtr & group() const {return spinner_->group;}

  /// Wake the executor: while it waits, that of rclcpp 29.3 keeps what is destroyed alive.
  void wake() {spinner_->group->trigger_notify_guard_condition();}

private:
  struct Spinner
  {
    explicit Spinner(rclcpp_lifecycle::LifecycleNode & node)
    : group(node.create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, false)),
      executor(options(node))
    {
      executor.add_callback_group(group, node.get_node_base_interface());
    }

    static rclcpp::ExecutorOptions options(rclcpp_lifecycle::LifecycleNode & node)
    {
      rclcpp::ExecutorOptions options;
      options.context = node.get_node_base_interface()->get_context();
      return options;
    }

    /// Return false after an exception of rclcpp; Calls catches those of the logic.
    bool spin(const std::string & name, const rclcpp::Logger & logger)
    {
      try {
        executor.spin();
        return true;
      } catch (const std::exception & error) {
        RCLCPP_ERROR(logger, "%s: %s", name.c_str(), error.what());
        return false;
      }
    }

    rclcpp::CallbackGroup::SharedPtr group;
    rclcpp::executors::SingleThreadedExecutor executor;
  };

  std::shared_ptr<Spinner> spinner_;
  std::future<void> ended_;
  std::thread thread_;
};

/// Return a pointer whose last copy wakes the executor of its thread.
///
/// While it waits, that of rclcpp 29.3 keeps what is destroyed alive: others would see it for ever.
template<typename Type>
std::shared_ptr<Type> waking(
  std::shared_ptr<Type> entity, const rclcpp::CallbackGroup::SharedPtr & group)
{
  const auto plain = entity.get();
  return {plain, [entity = std::move(entity), group](auto) mutable {
      entity.reset();
      group->trigger_notify_guard_condition();
    }};
}

}  // namespace all_kinds

#endif  // ROS__CALLBACK_THREAD_HPP_
