// What makes many mutants of one program.

#ifndef IS_MUTANT_HPP_
#define IS_MUTANT_HPP_

#include <cstdlib>
#include <string>

// Decision 76: all mutants are one program, which is built once.
/// Return whether the environment asks for this fault.
inline bool is_mutant(const std::string & fault)
{
  const char * asked = std::getenv("MUTANT");
  return asked && fault == asked;
}

#endif  // IS_MUTANT_HPP_
