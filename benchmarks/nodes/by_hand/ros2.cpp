// The two nodes for ROS 2 as its tutorials write them, in C++.

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "bench/record.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "std_msgs/msg/float64.hpp"
#include "std_msgs/msg/float64_multi_array.hpp"
#include "std_srvs/srv/set_bool.hpp"
#include "test_msgs/action/fibonacci.hpp"

using std_msgs::msg::Float64;
using std_msgs::msg::Float64MultiArray;
using std_srvs::srv::SetBool;
using test_msgs::action::Fibonacci;
using Goal = rclcpp_action::ServerGoalHandle<Fibonacci>;

class Relay : public rclcpp::Node
{
public:
  Relay()
  : Node("relay"), tick_(create_publisher<Float64>("tick", 10))
  {
    values_subscription_ = create_subscription<Float64MultiArray>(
      "values", 10,
      [this](Float64MultiArray::ConstSharedPtr message) {values_ = std::move(message);});
    timer_ = create_wall_timer(std::chrono::milliseconds(1), [this] {update();});
  }

  bench::Record record;

private:
  void update()
  {
    if (values_) {
      record.message(values_->data.at(0));
      values_.reset();
    }
    Float64 tick;
    tick.data = record.cycle();
    tick_->publish(tick);
  }

  Float64MultiArray::ConstSharedPtr values_;
  rclcpp::Publisher<Float64>::SharedPtr tick_;
  rclcpp::SubscriptionBase::SharedPtr values_subscription_;
  rclcpp::TimerBase::SharedPtr timer_;
};

class Server : public rclcpp::Node
{
public:
  Server()
  : Node("server")
  {
    values_ = create_subscription<Float64MultiArray>(
      "values", 10,
      [this](Float64MultiArray::ConstSharedPtr message) {record.message(message->data.at(0));});
    set_ = create_service<SetBool>(
      "set", [](SetBool::Request::SharedPtr request, SetBool::Response::SharedPtr response) {
        response->success = request->data;
      });
    compute_ = rclcpp_action::create_server<Fibonacci>(
      this, "compute",
      [](const rclcpp_action::GoalUUID &, std::shared_ptr<const Fibonacci::Goal>) {
        return rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;
      },
      [](std::shared_ptr<Goal>) {return rclcpp_action::CancelResponse::ACCEPT;},
      [](std::shared_ptr<Goal> goal) {
        std::thread(
          [goal] {
            auto result = std::make_shared<Fibonacci::Result>();
            result->sequence = {goal->get_goal()->order};
            goal->succeed(result);
          }).detach();
      });
  }

  bench::Record record;

private:
  rclcpp::SubscriptionBase::SharedPtr values_;
  rclcpp::ServiceBase::SharedPtr set_;
  rclcpp_action::Server<Fibonacci>::SharedPtr compute_;
};

template<typename Node>
void run()
{
  auto node = std::make_shared<Node>();
  rclcpp::spin(node);
  node->record.save();
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  argv[1] == std::string("relay") ? run<Relay>() : run<Server>();
}
