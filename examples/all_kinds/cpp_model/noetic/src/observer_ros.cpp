// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The node observer: its lifecycle and its ROS interfaces.
// Generated from all_kinds.ros_package.
// The logic is in observer_impl.cpp.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "all_kinds/observer_impl.hpp"
#include "all_kinds/observer_interface.hpp"
#include "ros/callback_thread.hpp"
#include "ros/inbox.hpp"
#include "ros/parameters.hpp"
#include "ros/process.hpp"
#include "ros/receiver.hpp"
#include "ros/ros.h"
#include "ros/ros_log.hpp"
#include "ros/supervisor.hpp"
#include "ros/synchronizer.hpp"
#include "ros/timing.hpp"

namespace all_kinds
{

constexpr double FREQUENCY = 12.5;  // Hz

/// The node and its life: configure, activate, update until it stops, deactivate, cleanup.
class ObserverNode
{
public:
  /// Read the parameters, create publishers and clients, and construct the logic.
  explicit ObserverNode(Supervisor & supervisor)
  : supervisor_(supervisor)
  {
    read_parameters();
    connect_senders();
    spinner_.start();
  }

  ObserverNode(const ObserverNode &) = delete;
  ObserverNode & operator=(const ObserverNode &) = delete;

  ~ObserverNode()
  {
    spinner_.stop();
  }

  /// Go through the lifecycle, in the thread of the logic.
  void live()
  {
    if (!supervisor_.step("configure", [this] {return impl_->configure(*config_);})) {
      supervisor_.refuse("The logic refused to configure.");
      return;
    }
    const auto activate = [this] {return impl_->activate();};
    if (!supervisor_.stopping() && supervisor_.step("activate", activate)) {
      work();
      supervisor_.waits().clear();
      supervisor_.step("deactivate", [this] {impl_->deactivate(); return true;});
    } else {
      supervisor_.refuse("The logic refused to activate.");
    }
    supervisor_.waits().clear();
    supervisor_.step("cleanup", [this] {impl_->cleanup(); return true;});
  }

  /// Abort the goals whose execution does not end.
  void abort_goals()
  {
    for (const auto & receiver : receivers_) {
      receiver->stop();
      receiver->abandon();
    }
  }

private:
  /// Return how often update runs, in Hz.
  double read_frequency() const
  {
    double frequency = FREQUENCY;
    read_parameter(private_, "frequency", frequency);
    check_range("frequency", frequency, 0.001, 100000.0);
    return frequency;
  }

  void read_parameters()
  {
    double stop_timeout = 2.0;
    read_parameter(private_, "stop_timeout", stop_timeout);
    supervisor_.set_stop_timeout(stop_timeout);
    ObserverConfig config;
    read_parameter(private_, "limit", config.limit);
    config_ = std::make_shared<ObserverConfig>(config);
  }

  /// Create publishers and clients, then the logic.
  void connect_senders()
  {
    ObserverPassthrough passthrough;
    passthrough.log = log_;
    passthrough.now = [] {
        return Time(static_cast<std::int64_t>(ros::Time::now().toNSec()));
      };
    passthrough.sleep = [this](double seconds) {return clock_.sleep(seconds);};
    passthrough.fail = [this](const std::string & reason) {
        supervisor_.fail("The logic failed: " + reason);
      };
    impl_ = std::make_unique<ObserverImpl>(passthrough);
  }

  /// Receive and update until the node stops.
  void work()
  {
    if (!supervisor_.stopping()) {
      supervisor_.guard("connect_receivers", [this] {connect_receivers();});
    }
    loop_.run(supervisor_, log_, [this] {update();});
    stop_receivers();
  }

  /// Create subscriptions and servers; each callback gets its own thread.
  void connect_receivers()
  {
    subscribe(
      node_,
      "/status",
      in_status_);
    const auto synchronizer_pair = synchronize<
      observer_types::PairLeft,
      observer_types::PairRight>(
      callback_thread("pair"),
      [this](const auto & ... messages) {
        supervisor_.guard(
          "receive_pair", [&] {
            impl_->receive_pair({messages ...});
          });
      },
      5);
    subscribe_input<0>(
      "left",
      synchronizer_pair);
    subscribe_input<1>(
      ros::names::resolve("~right", false),
      synchronizer_pair);
  }

  /// Wait for the callbacks to return. Subscriptions and servers last as long as the node: it takes
  /// an answer of the master to destroy them.
  void stop_receivers()
  {
    for (const auto & receiver : receivers_) {
      receiver->stop();
    }
    std::string late;
    for (const auto & receiver : receivers_) {
      if (!receiver->wait_until(supervisor_.deadline())) {
        late += (late.empty() ? "" : ", ") + receiver->name();
        receiver->abandon();
      }
    }
    if (!late.empty()) {
      supervisor_.report_late(late);
      return;
    }
    wait_for_sending();  // the last responses and results
  }

  /// Run one cycle: take the latest messages, call update.
  void update()
  {
    data_.in_status_updated = in_status_.take(data_.in_status);
    supervisor_.step("update", [this] {impl_->update(data_, *config_); return true;});
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
        10,
        [inbox](const boost::shared_ptr<Message> & message) {
          inbox.put(message);
        }));
  }

  /// Return the node handle of a thread of its own for callbacks.
  ros::NodeHandle & callback_thread(const std::string & name)
  {
    const auto thread = std::make_shared<CallbackThread>(node_, name);
    receivers_.push_back(thread);
    return thread->node();
  }

  /// Subscribe to a topic whose messages are joined with those of others.
  template<std::size_t Input, typename Joined>
  void subscribe_input(
    const std::string & topic,
    const std::shared_ptr<Joined> & synchronizer,
    std::uint32_t queue_size = 10,
    const ros::TransportHints & hints = ros::TransportHints())
  {
    using Message = typename Joined::template Message<Input>;
    subscribers_.push_back(
      synchronizer->node().template subscribe<Message>(
        topic,
        queue_size,
        [synchronizer](const boost::shared_ptr<const Message> & message) {
          synchronizer->template add<Input>(message);
        },
        ros::VoidConstPtr(),
        hints));
  }

  Supervisor & supervisor_;
  Logger log_{write_log};
  ros::NodeHandle node_;
  ros::NodeHandle private_{"~"};
  Clock clock_{node_, supervisor_.waits()};
  std::shared_ptr<const ObserverConfig> config_;
  Loop loop_{clock_, read_frequency()};
  ObserverData data_;
  Inbox<observer_types::InStatus> in_status_;
  std::unique_ptr<ObserverImpl> impl_;
  std::vector<std::shared_ptr<Receiver>> receivers_;
  std::vector<ros::Subscriber> subscribers_;
  ros::AsyncSpinner spinner_{1};
};

}  // namespace all_kinds

int main(int argc, char ** argv)
{
  return all_kinds::run_node<all_kinds::ObserverNode>(argc, argv, "observer");
}
