// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The interface between ROS and the logic of worker.
// Generated from all_kinds.ros_package; change the interface there.

#ifndef ALL_KINDS__WORKER_INTERFACE_HPP_
#define ALL_KINDS__WORKER_INTERFACE_HPP_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "all_kinds/ros/action_client.hpp"
#include "all_kinds/ros/goal.hpp"
#include "all_kinds/ros/logger.hpp"
#include "all_kinds/ros/logic_status.hpp"
#include "all_kinds/ros/publisher.hpp"
#include "all_kinds/ros/service_client.hpp"
#include "all_kinds/ros/time.hpp"
#include "all_kinds/ros/transforms.hpp"
#include "geometry_msgs/PointStamped.h"
#include "geometry_msgs/TransformStamped.h"
#include "geometry_msgs/Twist.h"
#include "geometry_msgs/TwistStamped.h"
#include "std_msgs/Empty.h"
#include "std_msgs/Int64.h"
#include "std_msgs/String.h"
#include "std_srvs/Empty.h"
#include "std_srvs/SetBool.h"
#include "std_srvs/Trigger.h"
#include "test_msgs/FibonacciAction.h"

namespace all_kinds
{

/// Message, service and action types, under the same names in ROS 1 and ROS 2.
namespace worker_types
{

using InSpeed = geometry_msgs::Twist;
using InCounter = std_msgs::Int64;
using OutCounter = std_msgs::Int64;
using OutStatus = std_msgs::String;
using PubEcho = std_msgs::String;
using PubEmpty = std_msgs::Empty;
using PubAnswer = std_msgs::String;
using SayMessage = std_msgs::String;
using CallMessage = std_msgs::String;
using SightingPoint = geometry_msgs::PointStamped;
using SightingMotion = geometry_msgs::TwistStamped;
using ClientPermit = std_srvs::Trigger;
using ResetService = std_srvs::Empty;
using EnableService = std_srvs::SetBool;
struct ActionDelegate
{
  using Type = test_msgs::FibonacciAction;
  using Goal = test_msgs::FibonacciGoal;
  using Feedback = test_msgs::FibonacciFeedback;
  using Result = test_msgs::FibonacciResult;
};
struct ComputeAction
{
  using Type = test_msgs::FibonacciAction;
  using Goal = test_msgs::FibonacciGoal;
  using Feedback = test_msgs::FibonacciFeedback;
  using Result = test_msgs::FibonacciResult;
};
struct MeasureAction
{
  using Type = test_msgs::FibonacciAction;
  using Goal = test_msgs::FibonacciGoal;
  using Feedback = test_msgs::FibonacciFeedback;
  using Result = test_msgs::FibonacciResult;
};
using Transform = geometry_msgs::TransformStamped;

/// Messages whose stamps belong together, for receive_sighting: valid until it returns.
struct SightingMessages
{
  /// What is seen
  const SightingPoint & point;

  /// How the worker moves
  const SightingMotion & motion;
};

}  // namespace worker_types

/// A snapshot of the node's parameters.
struct WorkerConfig
{
  /// What stands before a status, e.g. "a" < 'b' and so on
  std::string prefix = "it's \"said\" <so> & für immer";

  /// Where things are said again
  std::string echo_topic = "echo";

  /// Where to listen for calls
  std::vector<std::string> call_topics = {"hall/call", "~/call"};

  /// Where to answer
  std::vector<std::string> answer_topics = {"hall/answer", "/answer"};

  /// Weights of the inputs
  std::vector<double> weights = {0.5, 1.0, 2000.0};

  /// Gain of the output
  double gain = 1.5;

  /// How far to count in a cycle
  std::int64_t step = 1;

  /// Whether to say more
  bool verbose = false;

  /// Name in the status
  std::string label = "worker";
};

/// The input and output messages of one cycle.
///
/// in_<topic>: the latest message received; in_<topic>_updated: whether it is new.
/// out_<topic>: the message to publish; out_<topic>_active: whether this cycle publishes it.
/// out_<topic>_subscribers: how many subscribe to it.
struct WorkerData
{
  /// Wanted speed
  worker_types::InSpeed in_speed;
  bool in_speed_updated = false;

  /// Its own counter, heard again
  worker_types::InCounter in_counter;
  bool in_counter_updated = false;

  /// Cycles since the start
  worker_types::OutCounter out_counter;
  bool out_counter_active = true;
  std::size_t out_counter_subscribers = 0;

  /// What the worker does
  worker_types::OutStatus out_status;
  bool out_status_active = true;
  std::size_t out_status_subscribers = 0;
};

/// What the logic can use of ROS, in any of its methods.
struct WorkerPassthrough
{
  /// The node's logger: log.debug(text), log.info, log.warning, log.error; to write once:
  /// log.info_once(text); at most every two seconds: log.info_throttle(2.0, text).
  Logger log;

  /// Returns the ROS time; it converts to a message's stamp and back.
  std::function<Time()> now = [] {return Time();};

  /// Waits that many seconds of ROS time; returns false at once when the node stops.
  std::function<bool(double)> sleep = [](double) {return true;};

  /// Stops the node with an error, as an exception would, from any thread; logs the reason.
  std::function<void(const std::string &)> fail = [](const std::string &) {};

  /// What the logic says of itself on /diagnostics, from any thread.
  std::shared_ptr<LogicStatus> diagnostics = std::make_shared<LogicStatus>();

  /// What was said, said again
  std::shared_ptr<Publisher<worker_types::PubEcho>> pub_echo =
    std::make_shared<Publisher<worker_types::PubEcho>>();

  /// Nothing, as a message
  std::shared_ptr<Publisher<worker_types::PubEmpty>> pub_empty =
    std::make_shared<Publisher<worker_types::PubEmpty>>();

  /// What is answered in each room
  /// A publisher for each name in config.answer_topics.
  std::map<std::string, std::shared_ptr<Publisher<worker_types::PubAnswer>>> pub_answer;

  /// Asks whether it may work
  std::shared_ptr<ServiceClient<worker_types::ClientPermit>> client_permit =
    std::make_shared<ServiceClient<worker_types::ClientPermit>>();

  /// Lets another compute
  std::shared_ptr<ActionClient<worker_types::ActionDelegate>> action_delegate =
    std::make_shared<ActionClient<worker_types::ActionDelegate>>();

  /// Finds the worker
  std::shared_ptr<TransformListener<worker_types::Transform>> listener_frames =
    std::make_shared<TransformListener<worker_types::Transform>>();

  /// Says where the worker is
  std::shared_ptr<TransformBroadcaster<worker_types::Transform>> broadcaster_pose =
    std::make_shared<TransformBroadcaster<worker_types::Transform>>();
};

}  // namespace all_kinds

#endif  // ALL_KINDS__WORKER_INTERFACE_HPP_
