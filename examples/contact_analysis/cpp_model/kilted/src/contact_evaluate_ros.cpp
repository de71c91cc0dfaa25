// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

// The node contact_evaluate: its lifecycle and its ROS interfaces.
// Generated from contact_analysis.ros_package.
// The logic is in contact_evaluate_impl.cpp.

#include <memory>
#include <string>
#include <vector>

#include "contact_analysis/contact_evaluate_impl.hpp"
#include "contact_analysis/contact_evaluate_interface.hpp"
#include "rcl_interfaces/msg/parameter_descriptor.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "ros/action_server.hpp"
#include "ros/calls.hpp"
#include "ros/inbox.hpp"
#include "ros/managed_node.hpp"
#include "ros/ros_publisher.hpp"
#include "ros/service_server.hpp"
#include "ros/stop.hpp"
#include "ros/timing.hpp"
#include "ros/topics.hpp"

namespace contact_analysis
{

constexpr double FREQUENCY = 1000.0;  // Hz

/// The logic from configure to cleanup, with its ROS interfaces.
///
/// Publishers exist as long as it does. Subscriptions and service servers exist while it is
/// active. Action servers exist from its first activation on; while inactive, they reject goals.
class ContactEvaluateSession : public Session
{
public:
  /// The current parameters: replaced by atomic_store, read by atomic_load.
  using SharedConfig = std::shared_ptr<std::shared_ptr<const ContactEvaluateConfig>>;

  /// Create publishers and clients, then the logic.
  ContactEvaluateSession(
    ManagedNode & node,
    const SharedConfig & config,
    const std::shared_ptr<Loop> & loop)
  : config_(config),
    calls_(node.calls()),
    sleeper_(node.get_clock(), node.stop()),
    loop_(loop)
  {
    ContactEvaluatePassthrough passthrough;
    passthrough.log = make_logger(node.get_logger());
    passthrough.now = [clock = node.get_clock()] {return Time(clock->now().nanoseconds());};
    passthrough.sleep = [sleeper = sleeper_](double seconds) {return sleeper.sleep_for(seconds);};
    passthrough.fail = [calls = calls_](const std::string & reason) {
        calls->fail("The logic failed: " + reason);
      };
    passthrough.pub_plot_learn_cop =
      std::make_shared<RosPublisher<contact_evaluate_types::PubPlotLearnCop>>(
      topics_.advertise<contact_evaluate_types::PubPlotLearnCop>(
        node,
        "plot_learn_cop"));
    impl_ = std::make_shared<ContactEvaluateImpl>(passthrough);
  }

  bool configure() override {return impl_->configure(*std::atomic_load(config_.get()));}
  bool activate() override {return impl_->activate();}
  void deactivate() override {impl_->deactivate();}
  void cleanup() override {impl_->cleanup();}

  /// Run the update loop until the node stops.
  void work() override {loop_->run([this] {update();});}

  /// Create subscriptions and servers.
  void connect([[maybe_unused]] ManagedNode & node) override
  {
    topics_.subscribe(
      node,
      "cop",
      in_cop_);
    service_servers_.push_back(
      create_service_server<contact_evaluate_types::LoadService>(
        node,
        "load",
        impl_,
        &ContactEvaluateImpl::serve_load));
    service_servers_.push_back(
      create_service_server<contact_evaluate_types::StoreService>(
        node,
        "store",
        impl_,
        &ContactEvaluateImpl::serve_store));
    if (action_servers_.empty()) {
      action_servers_.push_back(
        std::make_unique<ActionServer<contact_evaluate_types::LearnAction>>(
          node,
          "learn",
          GoalPolicy::replace,
          impl_,
          &ContactEvaluateImpl::execute_learn));
      action_servers_.push_back(
        std::make_unique<ActionServer<contact_evaluate_types::EvaluateAction>>(
          node,
          "evaluate",
          GoalPolicy::replace,
          impl_,
          &ContactEvaluateImpl::execute_evaluate));
    }
    for (const auto & server : action_servers_) {
      server->start();
    }
  }

  /// Ask goals that are executed to end.
  void stop() override
  {
    for (const auto & server : action_servers_) {
      server->stop();
    }
  }

  /// Destroy subscriptions and service servers; give every goal a result.
  void disconnect() override
  {
    // Action servers stay, as a client may still ask for a result; inactive ones reject goals.
    for (const auto & server : action_servers_) {
      server->end();
    }
    topics_.unsubscribe();
    service_servers_.clear();
  }

  /// Wait until the last messages and results have been received.
  void flush(Stop::Clock::time_point end) override
  {
    topics_.flush(end);
    for (const auto & server : action_servers_) {
      server->flush(end);
    }
  }

private:
  /// Run one cycle: take the latest messages, call update.
  void update()
  {
    data_.in_cop_updated = in_cop_.take(data_.in_cop);
    impl_->update(data_, *std::atomic_load(config_.get()));
  }

  SharedConfig config_;
  std::shared_ptr<Calls> calls_;
  Sleeper sleeper_;
  std::shared_ptr<Loop> loop_;
  ContactEvaluateData data_;
  Inbox<contact_evaluate_types::InCop> in_cop_;
  Topics topics_;
  std::shared_ptr<ContactEvaluateImpl> impl_;
  std::vector<std::shared_ptr<void>> service_servers_;
  std::vector<std::unique_ptr<ActionServerBase>> action_servers_;
};

/// A managed node that runs its logic at a fixed frequency while it is active.
class ContactEvaluateNode : public ManagedNode
{
public:
  /// Declare the parameters; configure creates the session.
  explicit ContactEvaluateNode(const rclcpp::NodeOptions & options)
  : ManagedNode("contact_evaluate", options)
  {
    declare_parameters();
    std::atomic_store(config_.get(), read_config());
    parameters_callback_ = add_post_set_parameters_callback(
      [this](const std::vector<rclcpp::Parameter> &) {
        std::atomic_store(config_.get(), read_config());
      });
    fixed_ = {
      "samples",
    };
  }

  ~ContactEvaluateNode() override {end();}

private:
  std::shared_ptr<Session> make_session() override
  {
    return std::make_shared<ContactEvaluateSession>(*this, config_, loop_);
  }

  void declare_parameters()
  {
    using Descriptor = rcl_interfaces::msg::ParameterDescriptor;
    const ContactEvaluateConfig config;
    declare(
      "samples",
      config.samples,
      Descriptor().set__description("number of samples accumulated for learning"));
    declare(
      "pub_sample",
      config.pub_sample,
      Descriptor().set__description("Whether cop sampled should be published"));
  }

  /// Return the current parameters.
  std::shared_ptr<const ContactEvaluateConfig> read_config() const
  {
    const auto config = std::make_shared<ContactEvaluateConfig>();
    get_parameter("samples", config->samples);
    get_parameter("pub_sample", config->pub_sample);
    return config;
  }

  ContactEvaluateSession::SharedConfig config_ =
    std::make_shared<std::shared_ptr<const ContactEvaluateConfig>>(
    std::make_shared<const ContactEvaluateConfig>());
  std::shared_ptr<void> parameters_callback_;
  std::shared_ptr<Loop> loop_ =
    std::make_shared<Loop>(
    Sleeper(get_clock(), stop()),
    declare_frequency(FREQUENCY),
    get_logger());
};

/// Run the node in a process of its own.
int run_contact_evaluate(int argc, char ** argv)
{
  return run_node<ContactEvaluateNode>(argc, argv);
}

}  // namespace contact_analysis

RCLCPP_COMPONENTS_REGISTER_NODE(contact_analysis::ContactEvaluateNode)
