// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// Tests of the node idler: it starts, runs and stops.

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "class_loader/class_loader.hpp"
#include "gtest/gtest.h"
#include "lifecycle_msgs/msg/state.hpp"
#include "lifecycle_msgs/msg/transition.hpp"
#include "lifecycle_msgs/srv/change_state.hpp"
#include "lifecycle_msgs/srv/get_state.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/node_factory.hpp"

using lifecycle_msgs::msg::State;
using lifecycle_msgs::msg::Transition;
using lifecycle_msgs::srv::ChangeState;
using lifecycle_msgs::srv::GetState;

constexpr char NODE[] = "/idler/";
constexpr std::chrono::seconds TIMEOUT{10};

/// The node, loaded as a component, and a client of its life-cycle services.
class TestIdlerNode : public ::testing::Test
{
protected:
  static void SetUpTestSuite() {rclcpp::init(0, nullptr);}
  static void TearDownTestSuite() {rclcpp::shutdown();}

  void SetUp() override
  {
    const auto factory = loader.createInstance<rclcpp_components::NodeFactory>(
      "rclcpp_components::NodeFactoryTemplate<serving::IdlerNode>");
    wrapper = factory->create_node_instance(rclcpp::NodeOptions());
    executor.add_node(wrapper.get_node_base_interface());
    executor.add_node(client);
  }

  void TearDown() override
  {
    executor.remove_node(wrapper.get_node_base_interface());
  }

  template<typename Service>
  std::shared_ptr<typename Service::Response> call(
    const std::string & name,
    const std::shared_ptr<typename Service::Request> & request)
  {
    const auto caller = client->create_client<Service>(NODE + name);
    if (!caller->wait_for_service(TIMEOUT)) {
      return nullptr;
    }
    auto answer = caller->async_send_request(request);
    if (executor.spin_until_future_complete(answer, TIMEOUT) != rclcpp::FutureReturnCode::SUCCESS) {
      return nullptr;
    }
    return answer.get();
  }

  /// Return whether the node reaches a state before the timeout.
  bool reaches(std::uint8_t state)
  {
    const auto end = std::chrono::steady_clock::now() + TIMEOUT;
    while (std::chrono::steady_clock::now() < end) {
      const auto answer = call<GetState>("get_state", std::make_shared<GetState::Request>());
      if (answer && answer->current_state.id == state) {
        return true;
      }
      executor.spin_some(std::chrono::milliseconds(10));
    }
    return false;
  }

  bool change(std::uint8_t transition)
  {
    const auto request = std::make_shared<ChangeState::Request>();
    request->transition.id = transition;
    const auto answer = call<ChangeState>("change_state", request);
    return answer && answer->success;
  }

  class_loader::ClassLoader loader{COMPONENT_LIBRARY};
  rclcpp_components::NodeInstanceWrapper wrapper;
  rclcpp::Node::SharedPtr client = std::make_shared<rclcpp::Node>("test_client");
  rclcpp::executors::SingleThreadedExecutor executor;
};

TEST_F(TestIdlerNode, StartsByItselfAndObeysItsLifeCycle) {
  ASSERT_TRUE(reaches(State::PRIMARY_STATE_ACTIVE));
  EXPECT_TRUE(change(Transition::TRANSITION_DEACTIVATE));
  EXPECT_TRUE(change(Transition::TRANSITION_CLEANUP));
  EXPECT_TRUE(reaches(State::PRIMARY_STATE_UNCONFIGURED));
}
