// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__SYNCHRONIZER_HPP_
#define ROS__SYNCHRONIZER_HPP_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <tuple>

#include "message_filters/message_traits.hpp"
#include "message_filters/sync_policies/approximate_time.hpp"
#include "message_filters/sync_policies/exact_time.hpp"
#include "message_filters/synchronizer.hpp"
#include "rclcpp/rclcpp.hpp"

#include "managed_node.hpp"

namespace all_kinds
{

/// Joins messages of several topics by a policy of message_filters, for a method of the logic.
///
/// All of it runs in one thread, which its subscriptions share.
template<typename Policy, typename ... Messages>
class Synchronizer
{
public:
  /// The type of the messages of an input
  template<std::size_t Input>
  using Message = std::tuple_element_t<Input, std::tuple<Messages...>>;

  template<typename Logic, typename Joined>
  using Method = void (Logic::*)(const Joined &);

  template<typename Logic, typename Joined>
  Synchronizer(
    ManagedNode & node,
    const std::string & name,
    const std::shared_ptr<Logic> & logic,
    Method<Logic, Joined> receive,
    const Policy & policy)
  : callback_group_(node.callback_group("synchronizer", name)),
    joined_(policy)
  {
    static_assert(
      (message_filters::message_traits::HasHeader<Messages>::value && ...),
      "messages are joined by the stamps of their headers");
    // Weak, as an executor of rclcpp 29.3 that waits keeps its subscriptions alive. Before Kilted,
    // message_filters calls this with nine messages.
    const auto handle =
      [logic = std::weak_ptr<Logic>(logic), receive, calls = node.calls(),
        pass = node.calls()->pass(), label = "synchronizer " + name](
      const std::shared_ptr<const Messages> & ... messages, const auto & ...) {
        calls->run(
          pass, label, [&] {
            if (const auto owned = logic.lock()) {
              (owned.get()->*receive)(Joined{*messages ...});
            }
          });
      };
    joined_.registerCallback(handle);
  }

  const rclcpp::CallbackGroup::SharedPtr & callback_group() const {return callback_group_;}

  template<std::size_t Input>
  void add(const std::shared_ptr<const Message<Input>> & message)
  {
    joined_.template add<Input>(message);
  }

private:
  rclcpp::CallbackGroup::SharedPtr callback_group_;
  message_filters::Synchronizer<Policy> joined_;
};

/// Join messages whose stamps are equal; `queue_size` of each topic wait for the others.
template<typename ... Messages, typename Logic, typename Joined>
auto synchronize(
  ManagedNode & node,
  const std::string & name,
  const std::shared_ptr<Logic> & logic,
  void (Logic::* receive)(const Joined &),
  std::uint32_t queue_size)
{
  using Policy = message_filters::sync_policies::ExactTime<Messages...>;
  return std::make_shared<Synchronizer<Policy, Messages...>>(
    node, name, logic, receive, Policy(queue_size));
}

/// Join messages whose stamps are at most `slop` seconds apart; `queue_size` of each topic wait.
template<typename ... Messages, typename Logic, typename Joined>
auto synchronize(
  ManagedNode & node,
  const std::string & name,
  const std::shared_ptr<Logic> & logic,
  void (Logic::* receive)(const Joined &),
  std::uint32_t queue_size,
  double slop)
{
  using Policy = message_filters::sync_policies::ApproximateTime<Messages...>;
  Policy policy(queue_size);
  policy.setMaxIntervalDuration(rclcpp::Duration::from_seconds(slop));
  return std::make_shared<Synchronizer<Policy, Messages...>>(node, name, logic, receive, policy);
}

}  // namespace all_kinds

#endif  // ROS__SYNCHRONIZER_HPP_
