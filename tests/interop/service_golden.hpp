// Requests and responses as ROS 2 puts them on the wire, worked out by hand from the rules of plain CDR:
// behind the encapsulation 00010000 (little endian) the fields in their order, a number of n bytes at a
// multiple of n, a string as length with NUL (4 bytes), characters and NUL, a sequence as count (4 bytes) and
// elements, an empty message as one zero byte. In the texts a space stands between fields; padding is written
// in front of the field that asks for it and commented with the offset that it fills up to. Type hashes:
// printed by Jazzy's generator.
#pragma once

#include <string>
#include <vector>

namespace bw::test {

struct Golden {
  std::string service;  ///< as in service_examples.hpp
  std::string type;
  std::string request_hash;
  std::string response_hash;
  std::string request;   ///< hexadecimal
  std::string response;  ///< hexadecimal
};

/// "limits.v_max" and "use_sim_time" are 12 characters, so 13 with the NUL.
inline const std::string kVMax = "0d000000 6c696d6974732e765f6d617800";
inline const std::string kUseSimTime = "0d000000 7573655f73696d5f74696d6500";

/// The rest of a ParameterValue behind its string: five empty sequences.
inline const std::string kNoArrays = "00000000 00000000 00000000 00000000 00000000";

inline const std::vector<Golden>& golden() {
  // limits.v_max := 0.5 (3fe0000000000000), for both ways of setting.
  static const std::string kSetToHalf = "00010000 01000000 " + kVMax +
                                        " 03 00 " +                        // 4..21, type and bool: 23
                                        "00 0000000000000000 " +           // 24
                                        "000000000000e03f 01000000 00 " +  // 32..45
                                        "000000" + kNoArrays;              // 48
  static const std::vector<Golden> all = {
      {"trigger", "std_srvs/srv/Trigger", "d010825374ce8918e72bfd826c82603e60f45419e932ea976f807b74a863a199",
       "2d946c21e2fc3f1e9ca6986a8191d85fcc70097a8bb7771a053564bc47009cdf",
       "00010000 00",                                //
       "00010000 01 000000 06000000 61736b656400"},  // 4: "asked"
      {"empty", "std_srvs/srv/Empty",                //
       "458eaf200a3f63d9cc53d19436edebc0c140ef4c93ca75d5bd4ce19fd7759e35",
       "0a2858b3f60df644a61d0fa44cfc923a3d3628e0ad9c8ad8534b1a2c92a413dc", "00010000 00", "00010000 00"},
      {"set_bool", "std_srvs/srv/SetBool", "c62fbb99d94e1b25e8ef9e109f9581956bb1b3361a45a4e5810c36a90d29932e",
       "d0814e7f7b4880ab77e9c57426c7aa1562ab69f11eef8e2e968812f9cbd0b059",
       "00010000 01",                          //
       "00010000 00 000000 03000000 6e6f00"},  // 4: "no"
      {"list_parameters", "rcl_interfaces/srv/ListParameters",
       "a1b0b5d6b967a5b8ac5bc8563c3ea678f349e312a6a4967227c5a96bc5ce38df",
       "31b937b82de3612426be79f231e386259f97e8dc843e3f2845288b4bfa296bdd",
       "00010000 01000000 07000000 6c696d69747300"      // ["limits"], up to 15
       "00 0100000000000000",                           // 16: depth 1
       "00010000 01000000 " + kVMax +                   // up to 21
           "000000 01000000 07000000 6c696d69747300"},  // 24: ["limits"]
      {"get_parameters", "rcl_interfaces/srv/GetParameters",
       "135a9e1c3d7cebef792f6687d7ddf99949b21a0bd9a320d863a9110a3f5cf4d6",
       "9fa773b46e39cc5d02db6224d8fd520bb9caeeffc2b27c96c1e59431baba9f2a",
       "00010000 02000000 " + kVMax + "000000" + kUseSimTime,  // 21, 24
       "00010000 02000000 03 00 0000 0000000000000000 "        // double; 8: integer
       "000000000000e83f 01000000 00 "  // 16: 0.75 (3fe8000000000000), 24: no string, up to 29
       "000000" +
           kNoArrays +                                                  // 32..52
           "01 00 0000 0000000000000000 0000000000000000 01000000 00 "  // bool; 56: integer, 64, 72..77
           "000000" +
           kNoArrays},  // 80..100
      {"get_parameter_types", "rcl_interfaces/srv/GetParameterTypes",
       "87d7ec5ef545d4daa289d500025d31fb2437bc8b8365ca367161c4dac4be33fd",
       "ac1335dce67c478e669434f6ac2fbff34fcd529580f272d3006785ba8b54e47f",
       "00010000 02000000 " + kVMax + "000000" + kUseSimTime,  //
       "00010000 02000000 03 01"},
      {"set_parameters", "rcl_interfaces/srv/SetParameters",
       "130d46386b7e84ea9ecf60608a4d83cbe5e5cb7c6cc5b712b7a4e3a6c254e932",
       "7a0e8140a0b8d98308fa81a5403a766e610af29a239caf54b7553227906fc266", kSetToHalf,
       "00010000 01000000 00 000000 12000000 "   // 4: refused; 8: 17 characters
       "6d757374206265206174206d6f7374203200"},  // "must be at most 2"
      {"set_parameters_atomically", "rcl_interfaces/srv/SetParametersAtomically",
       "db0bd950ed5ed867a0e90b225e44dea382d762c0762ff3e0ee842190042a59e5",
       "31b1a38c5b0b9d893ee24da45f69638f4561c78461d82d52750f429b534502b8", kSetToHalf,
       "00010000 01 000000 01000000 00"},
      {"describe_parameters", "rcl_interfaces/srv/DescribeParameters",
       "05dd1c2bc87dec2627105c8070d6f9725c781a4f2ab852975bf105462b82b644",
       "ad6747319613c6131589e062e095b469a46cc764f7d0f12a001a49e6cd893995", "00010000 01000000 " + kVMax,
       "00010000 01000000 " + kVMax +
           " 03 "                                                 // up to 22
           "0000 0a000000 746f7020737065656400 "                  // 24: "top speed", up to 38
           "0000 0d000000 64656661756c7420302e373500 "            // 44: "default 0.75", up to 57
           "00 0000 01000000 "                                    // not read-only; 60: one range
           "0000000000000000 0000000000000040 0000000000000000 "  // 64: from 0 to 2, any step
           "00000000"},                                           // 88: no integer range
      {"get_state", "lifecycle_msgs/srv/GetState",
       "77a9c844e7975f15bc2221e8bbebafc4d118afb78c7f7071eef91f83f940f2f6",
       "fe249babab472e42cb5653b5d6a6b0c42a003b0fdfb84851aea3fde08760b4f5", "00010000 00",
       "00010000 03 000000 07000000 61637469766500"},  // 4: "active"
      {"change_state", "lifecycle_msgs/srv/ChangeState",
       "d74c6f524e14cade7b67e7297190360ed749264af300524fc1456f27cc2a553a",
       "e1ddfed0271fefe63767aa71561926e4d9eac0f1ddf9e71a8873eb46b36deac2",
       "00010000 03 000000 09000000 616374697661746500",  // 4: "activate"
       "00010000 01"},
      {"get_available_states", "lifecycle_msgs/srv/GetAvailableStates",
       "c2c0c12de6023822f284929577d4ca2862e0501150010966e8a90b632e4424de",
       "223e0dd5bb8a847ebb9532adaf8b5e2a97e6e68e79faeaabd81a45fb32925bd1", "00010000 00",
       "00010000 02000000 01 000000 0d000000 756e636f6e6669677572656400 "  // 8: "unconfigured", up to 25
       "03 0000 07000000 61637469766500"},                                 // 28: "active"
      {"get_available_transitions", "lifecycle_msgs/srv/GetAvailableTransitions",
       "52a73c0b5d7489bee0df6ddb0aec45c41289d223ff225b58fe11d859ac8109a6",
       "4711339461aadf02bcfff797a198de911f885074bd3f2fe9f7b677ef87f0741c", "00010000 00",
       "00010000 01000000 01 000000 0a000000 636f6e66696775726500 "  // 8: "configure", up to 22
       "01 00 0d000000 756e636f6e6669677572656400 "                  // 24: "unconfigured", up to 41
       "02 0000 09000000 696e61637469766500"},                       // 44: "inactive"
  };
  return all;
}

}  // namespace bw::test
