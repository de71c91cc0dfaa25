// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

// The node contact_evaluate: its lifecycle and its ROS interfaces.
// Generated from contact_analysis.ros_package.
// The logic is in contact_evaluate_impl.cpp.

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "contact_analysis/contact_evaluate_impl.hpp"
#include "contact_analysis/contact_evaluate_interface.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "ros/action_server.hpp"
#include "ros/calls.hpp"
#include "ros/cycle_counts.hpp"
#include "ros/inbox.hpp"
#include "ros/loop.hpp"
#include "ros/managed_node.hpp"
#include "ros/parameters.hpp"
#include "ros/ros_log.hpp"
#include "ros/ros_publisher.hpp"
#include "ros/service_server.hpp"
#include "ros/session.hpp"
#include "ros/sleeper.hpp"
#include "ros/snapshot.hpp"

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
  using SharedConfig = std::shared_ptr<Snapshot<ContactEvaluateConfig>>;

  /// Create publishers and clients, then the logic.
  ContactEvaluateSession(
    ManagedNode & node,
    const SharedConfig & config,
    const std::shared_ptr<CycleCounts> & cycles)
  : config_(config),
    calls_(node.calls()),
    sleeper_(node.get_clock(), node.stop()),
    logger_(node.get_logger()),
    cycles_(cycles)
  {
    ContactEvaluatePassthrough passthrough;
    passthrough.log = make_logger(node.get_logger());
    passthrough.now = [clock = node.get_clock()] {
        return Time(clock->now().nanoseconds());
      };
    passthrough.sleep = [sleeper = sleeper_](double seconds) {
        return sleeper.sleep_for(seconds);
      };
    passthrough.pub_plot_learn_cop = advertise<contact_evaluate_types::PubPlotLearnCop>(
      node,
      "plot_learn_cop");
    impl_ = std::make_shared<ContactEvaluateImpl>(passthrough);
  }

  bool configure() override {return impl_->configure(*config_->get());}
  bool activate() override {return impl_->activate();}
  void deactivate() override {impl_->deactivate();}
  void cleanup() override {impl_->cleanup();}

  /// Run the update loop until the node stops.
  void work() override
  {
    Loop loop(sleeper_, FREQUENCY, logger_, *cycles_);
    loop.run([this] {update();});
  }

  /// Create subscriptions and servers.
  void connect([[maybe_unused]] ManagedNode & node) override
  {
    subscribe(
      node,
      "cop",
      in_cop_);
    serve<contact_evaluate_types::LoadService>(
      node,
      "load",
      "service load",
      &ContactEvaluateImpl::serve_load);
    serve<contact_evaluate_types::StoreService>(
      node,
      "store",
      "service store",
      &ContactEvaluateImpl::serve_store);
    if (served_actions_.empty()) {
      serve_action<contact_evaluate_types::LearnAction>(
        node,
        "learn",
        GoalPolicy::replace,
        "action learn",
        &ContactEvaluateImpl::execute_learn);
      serve_action<contact_evaluate_types::EvaluateAction>(
        node,
        "evaluate",
        GoalPolicy::replace,
        "action evaluate",
        &ContactEvaluateImpl::execute_evaluate);
    }
    for (const auto & server : served_actions_) {
      server->start();
    }
  }

  /// Ask goals that are executed to end.
  void stop() override
  {
    for (const auto & server : served_actions_) {
      server->stop();
    }
  }

  /// Destroy subscriptions and servers; give every goal a result.
  void disconnect() override
  {
    // They stay, as a client may ask for a result later on; while inactive they reject goals.
    for (const auto & server : served_actions_) {
      server->end();
    }
    subscriptions_.clear();
    service_servers_.clear();
  }

  /// Wait until the last messages and results have been received.
  void flush(Stop::Clock::time_point end) override
  {
    wait_until_received(publishers_, end);
    for (const auto & server : served_actions_) {
      server->flush(end);
    }
  }

private:
  /// Run one cycle: take the latest messages, call update, publish the active outputs.
  void update()
  {
    data_.in_cop_updated = in_cop_.take(data_.in_cop);
    impl_->update(data_, *config_->get());
  }

  /// Create a publisher or subscription whose QoS can be overridden by parameters.
  template<typename Options, typename Create>
  static auto create_overridable(Options options, const Create & create)
  {
    options.qos_overriding_options = {
      rclcpp::QosPolicyKind::Depth,
      rclcpp::QosPolicyKind::Durability,
      rclcpp::QosPolicyKind::History,
      rclcpp::QosPolicyKind::Reliability};
    try {
      return create(options);
    } catch (const std::invalid_argument &) {
      // Within a process rclcpp lacks some policies, which the middleware has.
      options.use_intra_process_comm = rclcpp::IntraProcessSetting::Disable;
      return create(options);
    }
  }

  template<typename Message>
  std::shared_ptr<RosPublisher<Message>> advertise(
    ManagedNode & node,
    const std::string & topic,
    const rclcpp::QoS & qos = rclcpp::QoS(10))
  {
    const auto publisher = create_overridable(
      rclcpp::PublisherOptions(),
      [&](const rclcpp::PublisherOptions & options) {
        return rclcpp::create_publisher<Message>(node, topic, qos, options);
      });
    publishers_.push_back(publisher);
    return std::make_shared<RosPublisher<Message>>(
      publisher, node.get_node_options().use_intra_process_comms());
  }

  /// Subscribe to a topic whose latest message is an input of the next cycle.
  template<typename Message>
  void subscribe(
    ManagedNode & node,
    const std::string & topic,
    Inbox<Message> & inbox,
    const rclcpp::QoS & qos = rclcpp::QoS(10))
  {
    inbox = Inbox<Message>();  // Nothing of before is new.
    const auto receive = [inbox](std::unique_ptr<Message> message) {
        inbox.put(std::move(message));
      };
    subscriptions_.push_back(
      create_overridable(
        rclcpp::SubscriptionOptions(),
        [&](const rclcpp::SubscriptionOptions & options) {
          return node.create_subscription<Message>(topic, qos, receive, options);
        }));
  }

  /// Create a service server whose requests go to a method of the logic.
  template<typename Service>
  void serve(
    ManagedNode & node,
    const std::string & name,
    const std::string & label,
    void (ContactEvaluateImpl::* answer)(
      const typename Service::Request &,
      typename Service::Response &))
  {
    service_servers_.push_back(
      create_service_server<Service>(
        node,
        name,
        label,
        [impl = impl_, answer](const auto & request, auto & response) {
          (impl.get()->*answer)(request, response);
        }));
  }

  /// Create an action server whose goals go to a method of the logic.
  template<typename Action>
  void serve_action(
    ManagedNode & node,
    const std::string & name,
    GoalPolicy policy,
    const std::string & label,
    void (ContactEvaluateImpl::* execute)(Goal<Action> &))
  {
    served_actions_.push_back(
      std::make_unique<ActionServer<Action>>(
        node,
        name,
        policy,
        label,
        [impl = impl_, execute](Goal<Action> & goal) {
          (impl.get()->*execute)(goal);
        }));
  }

  SharedConfig config_;
  std::shared_ptr<Calls> calls_;
  Sleeper sleeper_;
  rclcpp::Logger logger_;
  std::shared_ptr<CycleCounts> cycles_;
  ContactEvaluateData data_;
  Inbox<contact_evaluate_types::InCop> in_cop_;
  std::vector<rclcpp::PublisherBase::SharedPtr> publishers_;
  std::shared_ptr<ContactEvaluateImpl> impl_;
  std::vector<std::shared_ptr<void>> subscriptions_;
  std::vector<std::shared_ptr<void>> service_servers_;
  std::vector<std::unique_ptr<ActionServerBase>> served_actions_;
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
    config_->set(read_config());
    parameters_callback_ = add_post_set_parameters_callback(
      [this](const std::vector<rclcpp::Parameter> &) {
        config_->set(read_config());
      });
    fix_while_configured(
      {
        "samples",
      });
  }

  ~ContactEvaluateNode() override {end();}

  ContactEvaluateNode(const ContactEvaluateNode &) = delete;
  ContactEvaluateNode & operator=(const ContactEvaluateNode &) = delete;

private:
  std::shared_ptr<Session> make_session() override
  {
    return std::make_shared<ContactEvaluateSession>(*this, config_, cycles_);
  }

  void declare_parameters()
  {
    const ContactEvaluateConfig config;
    declare_parameter(
      "samples",
      config.samples,
      described("number of samples accumulated for learning"));
    declare_parameter(
      "pub_sample",
      config.pub_sample,
      described("Whether cop sampled should be published"));
  }

  /// Return the current parameters.
  ContactEvaluateConfig read_config() const
  {
    ContactEvaluateConfig config;
    get_parameter("samples", config.samples);
    get_parameter("pub_sample", config.pub_sample);
    return config;
  }

  ContactEvaluateSession::SharedConfig config_ =
    std::make_shared<Snapshot<ContactEvaluateConfig>>();
  std::shared_ptr<void> parameters_callback_;
  std::shared_ptr<CycleCounts> cycles_ = std::make_shared<CycleCounts>();
};

/// Create the node for its own executable.
std::shared_ptr<ManagedNode> make_contact_evaluate_node(
  const rclcpp::NodeOptions & options)
{
  return std::make_shared<ContactEvaluateNode>(options);
}

}  // namespace contact_analysis

RCLCPP_COMPONENTS_REGISTER_NODE(contact_analysis::ContactEvaluateNode)
