# Compiles mistakes.cpp with COMPILER and OPTIONS. Each of its functions has to give an error with the message above it,
# which can be that of several functions. The first error has to be such a message, and if ARE_FEW, no function may give
# more than one other error, and more than a few lines, on the average.
cmake_minimum_required(VERSION 3.21)

set(most_lines_of_a_mistake 30)

set(program ${CMAKE_CURRENT_LIST_DIR}/mistakes.cpp)
execute_process(COMMAND ${COMPILER} ${OPTIONS} -fsyntax-only ${program} OUTPUT_VARIABLE output ERROR_VARIABLE output)

file(STRINGS ${program} messages REGEX "^// message: ")
list(TRANSFORM messages REPLACE "^// message: " "")
list(LENGTH messages number_of_messages)
set(different_messages ${messages})
list(REMOVE_DUPLICATES different_messages)
foreach(message IN LISTS different_messages)
  string(REGEX MATCHALL "error:[^\n]*${message}" errors "${output}")
  list(LENGTH errors number_of_errors)
  set(functions ${messages})
  list(FILTER functions INCLUDE REGEX "^${message}$")
  list(LENGTH functions number_of_functions)
  if(number_of_errors LESS number_of_functions OR (ARE_FEW AND number_of_errors GREATER number_of_functions))
    message(SEND_ERROR "${number_of_errors} errors say \"${message}\", expected ${number_of_functions}.")
  endif()
endforeach()

string(REGEX MATCHALL "error:[^\n]*" errors "${output}")
list(LENGTH errors number_of_errors)
string(REGEX MATCHALL "\n" lines "${output}")
list(LENGTH lines number_of_lines)
math(EXPR most_lines "${number_of_messages} * ${most_lines_of_a_mistake}")
math(EXPR most_errors "2 * ${number_of_messages}")
list(GET errors 0 first_error)
if(NOT first_error MATCHES "static.assert")
  message(SEND_ERROR "The first error is no message: ${first_error}")
endif()
if(ARE_FEW AND (number_of_errors GREATER most_errors OR number_of_lines GREATER most_lines))
  message(SEND_ERROR "${number_of_messages} mistakes give ${number_of_errors} errors in ${number_of_lines} lines:\n${output}")
endif()
