// The messages of which a service or an action is made on the wire. Its file defines what users fill in; what
// carries that is the same for all of them and derived as rosidl does.
#pragma once

#include "idl/compiler/model.hpp"

namespace bw::idl {

/// Completes the structs of <package>/srv/<Name>.idl and <package>/action/<Name>.idl, with the includes they
/// need: of a service <Name>_Event, of an action <Name>_SendGoal_Request and so on.
/// Throws std::runtime_error "<path>:<line>: what" if the file does not define exactly <Name>_Request and
/// <Name>_Response, or <Name>_Goal, <Name>_Result and <Name>_Feedback, in this order, or of a message <Name>,
/// in its own package. A path without a category is held to none of this.
void derive(File& file);

}  // namespace bw::idl
