// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__SYNCHRONIZER_HPP_
#define ROS__SYNCHRONIZER_HPP_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <tuple>

#include "message_filters/sync_policies/approximate_time.h"
#include "message_filters/sync_policies/exact_time.h"
#include "message_filters/synchronizer.h"
#include "ros/message_traits.h"
#include "ros/node_handle.h"

namespace all_kinds
{

/// Joins messages of several topics by a policy of message_filters, for a callback.
template<typename Policy, typename ... Messages>
class Synchronizer
{
public:
  /// The type of the messages of an input
  template<std::size_t Input>
  using Message = std::tuple_element_t<Input, std::tuple<Messages...>>;

  template<typename Receive>
  Synchronizer(ros::NodeHandle & node, const Receive & receive, const Policy & policy)
  : node_(node),
    joined_(policy)
  {
    static_assert(
      (ros::message_traits::HasHeader<Messages>::value && ...),
      "messages are joined by the stamps of their headers");
    joined_.registerCallback(Handle<Receive>{receive});
  }

  /// Return the node handle for the subscriptions: one thread has all their callbacks.
  ros::NodeHandle & node() {return node_;}

  template<std::size_t Input>
  void add(const boost::shared_ptr<const Message<Input>> & message)
  {
    joined_.template add<Input>(message);
  }

private:
  /// What message_filters calls, always with nine messages.
  template<typename Receive>
  struct Handle
  {
    using result_type = void;

    template<typename ... Nothing>
    void operator()(
      const boost::shared_ptr<const Messages> & ... messages, const Nothing & ...) const
    {
      receive(*messages ...);
    }

    Receive receive;
  };

  ros::NodeHandle & node_;
  message_filters::Synchronizer<Policy> joined_;
};

/// Join messages whose stamps are equal; `queue_size` of each topic wait for the others.
template<typename ... Messages, typename Receive>
auto synchronize(ros::NodeHandle & node, const Receive & receive, std::uint32_t queue_size)
{
  using Policy = message_filters::sync_policies::ExactTime<Messages...>;
  return std::make_shared<Synchronizer<Policy, Messages...>>(node, receive, Policy(queue_size));
}

/// Join messages whose stamps are at most `slop` seconds apart; `queue_size` of each topic wait.
template<typename ... Messages, typename Receive>
auto synchronize(
  ros::NodeHandle & node, const Receive & receive, std::uint32_t queue_size, double slop)
{
  using Policy = message_filters::sync_policies::ApproximateTime<Messages...>;
  Policy policy(queue_size);
  policy.setMaxIntervalDuration(ros::Duration(slop));
  return std::make_shared<Synchronizer<Policy, Messages...>>(node, receive, policy);
}

}  // namespace all_kinds

#endif  // ROS__SYNCHRONIZER_HPP_
