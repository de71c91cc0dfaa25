// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__TOPICS_HPP_
#define ROS__TOPICS_HPP_

#include <algorithm>
#include <cstddef>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "rclcpp/rclcpp.hpp"

#include "deadline.hpp"
#include "inbox.hpp"
#include "managed_node.hpp"
#include "stop.hpp"

namespace all_kinds
{

/// The publishers and subscriptions of a node; parameters can override their QoS.
class Topics
{
public:
  template<typename Message>
  std::shared_ptr<rclcpp::Publisher<Message>> advertise(
    ManagedNode & node, const std::string & topic, const rclcpp::QoS & qos = rclcpp::QoS(10))
  {
    const auto publisher = create(
      rclcpp::PublisherOptions(), [&](const rclcpp::PublisherOptions & options) {
        return rclcpp::create_publisher<Message>(node, topic, qos, options);
      });
    publishers_.push_back(publisher);
    return publisher;
  }

  /// Subscribe to a topic whose latest message is an input of the next cycle.
  template<typename Message>
  void subscribe(
    ManagedNode & node,
    const std::string & topic,
    Inbox<Message> & inbox,
    const rclcpp::QoS & qos = rclcpp::QoS(10),
    const std::shared_ptr<Deadline> & deadline = nullptr)
  {
    inbox = Inbox<Message>();  // Messages from before the activation are not new.
    const auto receive = [inbox, deadline](std::unique_ptr<Message> message) {
        if (deadline) {
          deadline->heard();
        }
        inbox.put(std::move(message));
      };
    subscriptions_.push_back(
      create(
        rclcpp::SubscriptionOptions(), [&](const rclcpp::SubscriptionOptions & options) {
          return node.create_subscription<Message>(topic, qos, receive, options);
        }));
  }

  /// Subscribe to a topic whose messages go to a method of the logic, in a thread of their own.
  template<typename Message, typename Logic>
  void subscribe(
    ManagedNode & node,
    const std::string & name,
    const std::string & topic,
    const std::shared_ptr<Logic> & logic,
    void (Logic::* receive)(const Message &),
    const rclcpp::QoS & qos = rclcpp::QoS(10),
    const std::shared_ptr<Deadline> & deadline = nullptr)
  {
    // Weak, as an executor of rclcpp 29.3 that waits keeps its subscriptions alive.
    const auto handle = [logic = std::weak_ptr<Logic>(logic), receive, calls = node.calls(),
        pass = node.calls()->pass(), label = "topic " + topic, deadline](const Message & message) {
        calls->run(
          pass, label, [&] {
            if (const auto owned = logic.lock()) {
              const auto handle = [&] {(owned.get()->*receive)(message);};
              deadline ? deadline->handle(handle) : handle();
            }
          });
      };
    rclcpp::SubscriptionOptions in_its_thread;
    in_its_thread.callback_group = node.callback_group("topic", name);
    subscriptions_.push_back(
      create(
        in_its_thread, [&](const rclcpp::SubscriptionOptions & options) {
          return node.create_subscription<Message>(topic, qos, handle, options);
        }));
  }

  /// Subscribe to topics whose messages go to a method of the logic, all in one thread of its own.
  template<typename Message, typename Logic>
  void subscribe(
    ManagedNode & node,
    const std::string & name,
    const std::vector<std::string> & topics,
    const std::shared_ptr<Logic> & logic,
    void (Logic::* receive)(const std::string &, const Message &),
    const rclcpp::QoS & qos = rclcpp::QoS(10))
  {
    rclcpp::SubscriptionOptions in_its_thread;
    in_its_thread.callback_group = node.callback_group("topics", name);
    for (const auto & topic : topics) {
      const auto handle = [logic = std::weak_ptr<Logic>(logic), receive, calls = node.calls(),
          pass = node.calls()->pass(), topic, label = "topic " + topic](const Message & message) {
          calls->run(
            pass, label, [&] {
              if (const auto owned = logic.lock()) {
                (owned.get()->*receive)(topic, message);
              }
            });
        };
      subscriptions_.push_back(
        create(
          in_its_thread, [&](const rclcpp::SubscriptionOptions & options) {
            return node.create_subscription<Message>(topic, qos, handle, options);
          }));
    }
  }

  /// Subscribe to a topic whose messages a synchronizer joins with those of others.
  template<std::size_t Input, typename Synchronizer>
  void subscribe_input(
    ManagedNode & node,
    const std::string & topic,
    const std::shared_ptr<Synchronizer> & synchronizer,
    const rclcpp::QoS & qos = rclcpp::QoS(10))
  {
    using Message = typename Synchronizer::template Message<Input>;
    const auto receive = [synchronizer](std::shared_ptr<const Message> message) {
        synchronizer->template add<Input>(message);
      };
    rclcpp::SubscriptionOptions in_its_thread;
    in_its_thread.callback_group = synchronizer->callback_group();
    subscriptions_.push_back(
      create(
        in_its_thread, [&](const rclcpp::SubscriptionOptions & options) {
          return node.create_subscription<Message>(topic, qos, receive, options);
        }));
  }

  void unsubscribe() {subscriptions_.clear();}

  /// Wait until the subscribers have received what was published last.
  void flush(Stop::Clock::time_point end) const
  {
    for (const auto & publisher : publishers_) {
      const auto left = std::max(end - Stop::Clock::now(), Stop::Clock::duration::zero());
      try {
        publisher->wait_for_all_acked(left);
      } catch (const std::exception &) {
        return;  // The middleware does not support it.
      }
    }
  }

private:
  template<typename Options, typename Create>
  static auto create(Options options, const Create & create_endpoint)
  {
    options.qos_overriding_options = {
      rclcpp::QosPolicyKind::Depth,
      rclcpp::QosPolicyKind::Durability,
      rclcpp::QosPolicyKind::History,
      rclcpp::QosPolicyKind::Reliability};
    try {
      return create_endpoint(options);
    } catch (const std::invalid_argument &) {
      // Intra-process, rclcpp refuses keep_all (29.3) and transient_local (16).
      options.use_intra_process_comm = rclcpp::IntraProcessSetting::Disable;
      return create_endpoint(options);
    }
  }

  std::vector<rclcpp::PublisherBase::SharedPtr> publishers_;
  std::vector<rclcpp::SubscriptionBase::SharedPtr> subscriptions_;
};

}  // namespace all_kinds

#endif  // ROS__TOPICS_HPP_
