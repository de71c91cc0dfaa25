// The two nodes for ROS 1 as its tutorials write them, in C++.

#include <string>

#include "actionlib/server/simple_action_server.h"
#include "bench/record.hpp"
#include "ros/ros.h"
#include "std_msgs/Float64.h"
#include "std_msgs/Float64MultiArray.h"
#include "std_srvs/SetBool.h"
#include "test_msgs/FibonacciAction.h"

class Relay
{
public:
  Relay()
  : tick_(handle_.advertise<std_msgs::Float64>("tick", 10)),
    subscriber_(handle_.subscribe("values", 10, &Relay::receive, this))
  {
  }

  void run()
  {
    ros::Rate rate(1000);
    while (ros::ok()) {
      ros::spinOnce();
      update();
      rate.sleep();
    }
  }

  bench::Record record;

private:
  void receive(const std_msgs::Float64MultiArray::ConstPtr & message)
  {
    values_ = message;
  }

  void update()
  {
    if (values_) {
      record.message(values_->data.at(0));
      values_.reset();
    }
    std_msgs::Float64 tick;
    tick.data = record.cycle();
    tick_.publish(tick);
  }

  ros::NodeHandle handle_;
  std_msgs::Float64MultiArray::ConstPtr values_;
  ros::Publisher tick_;
  ros::Subscriber subscriber_;
};

class Server
{
public:
  Server()
  : subscriber_(handle_.subscribe("values", 10, &Server::receive, this)),
    set_(handle_.advertiseService("set", &Server::serve, this)),
    compute_(handle_, "compute", [this](const test_msgs::FibonacciGoalConstPtr & goal) {
        test_msgs::FibonacciResult result;
        result.sequence = {goal->order};
        compute_.setSucceeded(result);
      }, false)
  {
    compute_.start();
  }

  void run()
  {
    ros::spin();
  }

  bench::Record record;

private:
  void receive(const std_msgs::Float64MultiArray::ConstPtr & message)
  {
    record.message(message->data.at(0));
  }

  bool serve(std_srvs::SetBool::Request & request, std_srvs::SetBool::Response & response)
  {
    response.success = request.data;
    return true;
  }

  ros::NodeHandle handle_;
  ros::Subscriber subscriber_;
  ros::ServiceServer set_;
  actionlib::SimpleActionServer<test_msgs::FibonacciAction> compute_;
};

template<typename Node>
void run()
{
  Node node;
  node.run();
  node.record.save();
}

int main(int argc, char ** argv)
{
  ros::init(argc, argv, argv[1]);
  argv[1] == std::string("relay") ? run<Relay>() : run<Server>();
}
