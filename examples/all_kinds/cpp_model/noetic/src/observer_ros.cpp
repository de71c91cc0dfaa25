// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The node observer: its life-cycle and its ROS interfaces.
// Generated from all_kinds.ros_package.
// The logic is in observer_impl.cpp.

#include <cstdint>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "all_kinds/observer_impl.hpp"
#include "all_kinds/observer_interface.hpp"
#include "inbox.hpp"
#include "parameters.hpp"
#include "ros/ros.h"
#include "ros_log.hpp"

namespace all_kinds
{

constexpr double FREQUENCY = 12.5;  // Hz
constexpr std::uint32_t QUEUE = 10;  // messages kept for a topic

/// A node that runs its logic at a fixed frequency until shutdown.
class ObserverNode
{
public:
  /// Read the parameters, create publishers and clients, and construct the logic.
  ObserverNode()
  {
    read_parameters();
    connect_senders();
  }

  ObserverNode(const ObserverNode &) = delete;
  ObserverNode & operator=(const ObserverNode &) = delete;

  /// Destroy subscriptions and servers, then clean up the logic.
  ~ObserverNode()
  {
    spinner_.stop();
    subscribers_.clear();
    if (configured_) {
      impl_->cleanup();
    }
  }

  /// Configure the logic, connect its callbacks, and run the update loop until shutdown.
  bool run()
  {
    if (!impl_->configure(*config_)) {
      ROS_FATAL("The logic rejected its configuration.");
      return false;
    }
    configured_ = true;
    connect_receivers();
    spinner_.start();
    ros::Rate rate(FREQUENCY);
    while (ros::ok()) {
      update();
      rate.sleep();
    }
    return true;
  }

private:
  void read_parameters()
  {
    ObserverConfig config;
    read_parameter(private_, "limit", config.limit);
    config_ = std::make_shared<ObserverConfig>(config);
  }

  /// Create publishers and clients, then the logic.
  void connect_senders()
  {
    ObserverPassthrough passthrough;
    passthrough.log = Logger(write_log);
    passthrough.now = [] {
        return Time(static_cast<std::int64_t>(ros::Time::now().toNSec()));
      };
    impl_ = std::make_unique<ObserverImpl>(passthrough);
  }

  /// Create subscriptions and servers; callbacks that may block get their own thread.
  void connect_receivers()
  {
    subscribe(
      node_,
      "/status",
      in_status_);
  }

  /// Run one cycle: take the latest messages, call update, publish the active outputs.
  void update()
  {
    data_.in_status_updated = in_status_.take(data_.in_status);
    impl_->update(data_, *config_);
  }

  /// Subscribe to a topic whose latest message is an input of the next cycle.
  template<typename Message>
  void subscribe(
    ros::NodeHandle & node,
    const std::string & topic,
    const Inbox<Message> & inbox)
  {
    subscribers_.push_back(
      node.subscribe<Message, const boost::shared_ptr<Message> &>(
        topic,
        QUEUE,
        [inbox](const boost::shared_ptr<Message> & message) {
          inbox.put(message);
        }));
  }

  ros::NodeHandle node_;
  ros::NodeHandle private_{"~"};
  std::shared_ptr<const ObserverConfig> config_;
  ObserverData data_;
  Inbox<observer_types::InStatus> in_status_;
  std::unique_ptr<ObserverImpl> impl_;
  bool configured_ = false;
  std::vector<ros::Subscriber> subscribers_;
  ros::AsyncSpinner spinner_{1};
};

}  // namespace all_kinds

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "observer");
  all_kinds::set_log_level();
  try {
    return all_kinds::ObserverNode().run() ? 0 : 1;
  } catch (const std::exception & error) {
    ROS_FATAL("%s", error.what());
    return 1;
  }
}
