// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__THREAD_NAME_HPP_
#define ROS__THREAD_NAME_HPP_

#ifdef __linux__
#include <pthread.h>
#endif

#include <string>

namespace serving
{

/// Name the calling thread for `top -H` and debuggers, with the 15 characters that Linux keeps.
inline void name_this_thread(const std::string & name)
{
#ifdef __linux__
  pthread_setname_np(pthread_self(), name.substr(0, 15).c_str());
#else
  static_cast<void>(name);
#endif
}

}  // namespace serving

#endif  // ROS__THREAD_NAME_HPP_
