// Type hashes against those that ROS 2 Jazzy's own generator gives (without "RIHS01_").
#include "idl/compiler/type_hash.hpp"

#include <string>

#include <gtest/gtest.h>

#include "idl/compiler/parser.hpp"
#include "runtime/wire/type_registry.hpp"

namespace bw::test {
namespace {

struct Row {
  const char* ros_name;
  const char* hash;
};

constexpr Row kJazzy[] = {
    {"action_msgs/msg/GoalInfo", "6398fe763154554353930716b225947f93b672f0fb2e49fdd01bb7a7e37933e9"},
    {"action_msgs/msg/GoalStatusArray", "6c1684b00f177d37438febe6e709fc4e2b0d4248dca4854946f9ed8b30cda83e"},
    {"action_msgs/srv/CancelGoal_Request",
     "3d3c84653c1f96918086887e1dcb236faec88b81a5b14fd4cf4840065bcdf8af"},
    {"action_msgs/srv/CancelGoal_Response",
     "35e682cf3f510e83c70a82a4aac888496dedee56773bf9d8e5e0aa81f9e1c960"},
    {"builtin_interfaces/msg/Duration", "e8d009f659816f758b75334ee1a9ca5b5c0b859843261f14c7f937349599d93b"},
    {"builtin_interfaces/msg/Time", "b106235e25a4c5ed35098aa0a61a3ee9c9b18d197f398b0e4206cea9acf9c197"},
    {"composition_interfaces/srv/ListNodes_Request",
     "57c879a1825b3fa15fd58e70d2e73223af6b9c45c7ae104cc107e73464d3a724"},
    {"composition_interfaces/srv/ListNodes_Response",
     "b7cd8401aedcd85c4cedce384944001d5c1ab611e0164a8207045cfcaf4a2584"},
    {"composition_interfaces/srv/LoadNode_Request",
     "7d3496175f54f92d652547e144c9b2a3b22afd604f84ed70adfcd1cfe35801b5"},
    {"composition_interfaces/srv/LoadNode_Response",
     "08cdf942efabec2448fd03c131f3627a33ed05376400612425f871feb87ca9fd"},
    {"composition_interfaces/srv/UnloadNode_Request",
     "95d5cfc357956740190c7685ac868d9c7c98dcb8c1416aae8eaa351422074e12"},
    {"composition_interfaces/srv/UnloadNode_Response",
     "fa7fc38f9206220a6bc1558a3c019269e5aa592f7fae01dffbd19f56eb86d599"},
    {"diagnostic_msgs/msg/DiagnosticArray",
     "5a8a36efb05fb25070fa0fb3810290c0e6cd4862b54a8fb975a1ee8dc55a333e"},
    {"diagnostic_msgs/msg/DiagnosticStatus",
     "b0e3e692ea2d54a8af2f4ef1930e81556a2db55216b771f8a7d2724ed47bf0e4"},
    {"diagnostic_msgs/msg/KeyValue", "d68081eaa540288c5440753baecef0c4e16e81a5f78ad68902ded5100413bb42"},
    {"geometry_msgs/msg/Point", "6963084842a9b04494d6b2941d11444708d892da2f4b09843b9c43f42a7f6881"},
    {"geometry_msgs/msg/Point32", "2fc4db7cae16a4582c79a56b66173a8d48d52c7dc520ddc55a0d4bcf2a4bfdbc"},
    {"geometry_msgs/msg/Polygon", "3782f9f0bf044964d692d6c017d705e37611afb1f0bf6a9dee248a7dda0f784a"},
    {"geometry_msgs/msg/PolygonStamped", "b7cf07932f1523d4b4088075945c1a0141f7cd21da87cc940fc61652e9138b46"},
    {"geometry_msgs/msg/Pose", "d501954e9476cea2996984e812054b68026ae0bfae789d9a10b23daf35cc90fa"},
    {"geometry_msgs/msg/PoseArray", "af0cc36d190e104d546d168d6b39df04fa4b4ccecf59cb4c9ed328d3d5004aa0"},
    {"geometry_msgs/msg/PoseStamped", "10f3786d7d40fd2b54367835614bff85d4ad3b5dab62bf8bca0cc232d73b4cd8"},
    {"geometry_msgs/msg/PoseWithCovariance",
     "9a7c0fd234b7f45c6098745ecccd773ca1085670e64107135397aee31c02e1bb"},
    {"geometry_msgs/msg/PoseWithCovarianceStamped",
     "26432f9803e43727d3c8f668d1fdb3c630f548af631e2f4e31382371bfea3b6e"},
    {"geometry_msgs/msg/Quaternion", "8a765f66778c8ff7c8ab94afcc590a2ed5325a1d9a076ffff38fbce36f458684"},
    {"geometry_msgs/msg/Transform", "beb83fbe698636351461f6f35d1abb20010c43d55374d81bd041f1ba2581fddc"},
    {"geometry_msgs/msg/TransformStamped",
     "0a241f87d04668d94099cbb5ba11691d5ad32c2f29682e4eb5653424bd275206"},
    {"geometry_msgs/msg/Twist", "9c45bf16fe0983d80e3cfe750d6835843d265a9a6c46bd2e609fcddde6fb8d2a"},
    {"geometry_msgs/msg/TwistStamped", "5f0fcd4f81d5d06ad9b4c4c63e3ea51b82d6ae4d0558f1d475229b1121db6f64"},
    {"geometry_msgs/msg/TwistWithCovariance",
     "49f574f033f095d8b6cd1beaca5ca7925e296e84af1716d16c89d38b059c8c18"},
    {"geometry_msgs/msg/Vector3", "cc12fe83e4c02719f1ce8070bfd14aecd40f75a96696a67a2a1f37f7dbb0765d"},
    {"lifecycle_msgs/msg/State", "dd2d02b82f3ebc858e53c431b1e6e91f3ffc71436fc81d0715214ac6ee2107a0"},
    {"lifecycle_msgs/msg/TransitionEvent",
     "d5f8873a2f0146498f812d7885c7327ce27e463d36811d8792f35ee38c0d6c38"},
    {"lifecycle_msgs/srv/ChangeState_Request",
     "d74c6f524e14cade7b67e7297190360ed749264af300524fc1456f27cc2a553a"},
    {"lifecycle_msgs/srv/ChangeState_Response",
     "e1ddfed0271fefe63767aa71561926e4d9eac0f1ddf9e71a8873eb46b36deac2"},
    {"lifecycle_msgs/srv/GetAvailableStates_Request",
     "c2c0c12de6023822f284929577d4ca2862e0501150010966e8a90b632e4424de"},
    {"lifecycle_msgs/srv/GetAvailableStates_Response",
     "223e0dd5bb8a847ebb9532adaf8b5e2a97e6e68e79faeaabd81a45fb32925bd1"},
    {"lifecycle_msgs/srv/GetAvailableTransitions_Request",
     "52a73c0b5d7489bee0df6ddb0aec45c41289d223ff225b58fe11d859ac8109a6"},
    {"lifecycle_msgs/srv/GetAvailableTransitions_Response",
     "4711339461aadf02bcfff797a198de911f885074bd3f2fe9f7b677ef87f0741c"},
    {"lifecycle_msgs/srv/GetState_Request",
     "77a9c844e7975f15bc2221e8bbebafc4d118afb78c7f7071eef91f83f940f2f6"},
    {"lifecycle_msgs/srv/GetState_Response",
     "fe249babab472e42cb5653b5d6a6b0c42a003b0fdfb84851aea3fde08760b4f5"},
    {"nav2_msgs/action/NavigateToPose_FeedbackMessage",
     "9d1f6fa2eb975ce733b419ac2e97b134d8ff92b6478b6559feed9a50bdfd82b3"},
    {"nav2_msgs/action/NavigateToPose_GetResult_Request",
     "106d3457cf0db4c4a8d3373bab3ff6aa8ba8ad99ae6392ce9784830a7d04ac93"},
    {"nav2_msgs/action/NavigateToPose_GetResult_Response",
     "c59f178c377de5318919c00bdbf7884cb3b185acfdffceba6c9f161e0aa3cc81"},
    {"nav2_msgs/action/NavigateToPose_SendGoal_Request",
     "e9381f2acfe9fa8c4838a277d0cde28a93c483564827b9f13496b9c2092e4f09"},
    {"nav2_msgs/action/NavigateToPose_SendGoal_Response",
     "99f97fcbb07daf024df4b8c3f02f19ce7fa3183fcedfb76b8772a61a371a55fa"},
    {"nav2_msgs/msg/ParticleCloud", "193d8cb88ca2b98cd81ece15342744f054bb398ebfa8f6369914432303f42b11"},
    {"nav2_msgs/msg/SpeedLimit", "83d8e4e842559f4d9a988b19d31b162216ec738536389f98438d1a166f91845a"},
    {"nav2_msgs/srv/ClearEntireCostmap_Request",
     "365687a69e15ff9f199447a047ab6fdd264272e6b4d12de0b71bd4a6e4137e99"},
    {"nav2_msgs/srv/ClearEntireCostmap_Response",
     "a0aeab7debb4b503bf8d5edcadb896864aa3dda700452d8c9cfa6c4755956665"},
    {"nav2_msgs/srv/ManageLifecycleNodes_Request",
     "927841759575a5565b3d879a58fd035a5a69e9fdf3365c02b33cc9ad03a7a227"},
    {"nav2_msgs/srv/ManageLifecycleNodes_Response",
     "3ab0ddcbe7307ad89c089d1a8749030929efc63c22ec506faf11440ec2f5c159"},
    {"nav_msgs/msg/MapMetaData", "2772d4b2000ef2b35dbaeb80fd3946c1369f817fb4f75677d916d27c17d763c8"},
    {"nav_msgs/msg/OccupancyGrid", "8d348150c12913a31ee0ec170fbf25089e4745d17035792a1ba94d6f0bc0cfc7"},
    {"nav_msgs/msg/Odometry", "3cc97dc7fb7502f8714462c526d369e35b603cfc34d946e3f2eda2766dfec6e0"},
    {"nav_msgs/msg/Path", "1957a5bb3cee5da65c4e52e52b65a93df227efce4c20f8458b36e73066ca334b"},
    {"nav_msgs/srv/GetMap_Request", "b531e302f1bd6a81f8a5e03453266c378b1f711b4296000c1c0f53a40e00a7c4"},
    {"nav_msgs/srv/GetMap_Response", "45246f7a2ff0cbfa46e13865d4b95929ebb6d2846d1b85a20ad51030f4690dc2"},
    {"nav_msgs/srv/LoadMap_Request", "0f8fe3aac433c977d7c2f8b57ab1c3a17677e24880d76919b69e4208e99f5132"},
    {"nav_msgs/srv/LoadMap_Response", "e7970ddf9f58e10d34b5eae6d2baca31b2b3e2f2fe6d082b3aae2a5f92777b2a"},
    {"rcl_interfaces/msg/Log", "e28ce254ca8abc06abf92773b74602cdbf116ed34fbaf294fb9f81da9f318eac"},
    {"rcl_interfaces/msg/ParameterDescriptor",
     "52175dbfda6c51153101d33d2a9da05743f66f02d5ab2ca9ec4709b46b73d704"},
    {"rcl_interfaces/msg/ParameterEvent", "043e627780fcad87a22d225bc2a037361dba713fca6a6b9f4b869a5aa0393204"},
    {"rcl_interfaces/msg/ParameterValue", "115fc089a387e23c7ecd3525c9189c379109119d6ab82e8dfbde0fdf6a7f9b68"},
    {"rcl_interfaces/srv/DescribeParameters_Request",
     "05dd1c2bc87dec2627105c8070d6f9725c781a4f2ab852975bf105462b82b644"},
    {"rcl_interfaces/srv/DescribeParameters_Response",
     "ad6747319613c6131589e062e095b469a46cc764f7d0f12a001a49e6cd893995"},
    {"rcl_interfaces/srv/GetParameterTypes_Request",
     "87d7ec5ef545d4daa289d500025d31fb2437bc8b8365ca367161c4dac4be33fd"},
    {"rcl_interfaces/srv/GetParameterTypes_Response",
     "ac1335dce67c478e669434f6ac2fbff34fcd529580f272d3006785ba8b54e47f"},
    {"rcl_interfaces/srv/GetParameters_Request",
     "135a9e1c3d7cebef792f6687d7ddf99949b21a0bd9a320d863a9110a3f5cf4d6"},
    {"rcl_interfaces/srv/GetParameters_Response",
     "9fa773b46e39cc5d02db6224d8fd520bb9caeeffc2b27c96c1e59431baba9f2a"},
    {"rcl_interfaces/srv/ListParameters_Request",
     "a1b0b5d6b967a5b8ac5bc8563c3ea678f349e312a6a4967227c5a96bc5ce38df"},
    {"rcl_interfaces/srv/ListParameters_Response",
     "31b937b82de3612426be79f231e386259f97e8dc843e3f2845288b4bfa296bdd"},
    {"rcl_interfaces/srv/SetParametersAtomically_Request",
     "db0bd950ed5ed867a0e90b225e44dea382d762c0762ff3e0ee842190042a59e5"},
    {"rcl_interfaces/srv/SetParametersAtomically_Response",
     "31b1a38c5b0b9d893ee24da45f69638f4561c78461d82d52750f429b534502b8"},
    {"rcl_interfaces/srv/SetParameters_Request",
     "130d46386b7e84ea9ecf60608a4d83cbe5e5cb7c6cc5b712b7a4e3a6c254e932"},
    {"rcl_interfaces/srv/SetParameters_Response",
     "7a0e8140a0b8d98308fa81a5403a766e610af29a239caf54b7553227906fc266"},
    {"rosgraph_msgs/msg/Clock", "692f7a66e93a3c83e71765d033b60349ba68023a8c689a79e48078bcb5c58564"},
    {"sensor_msgs/msg/Imu", "7d9a00ff131080897a5ec7e26e315954b8eae3353c3f995c55faf71574000b5b"},
    {"sensor_msgs/msg/JointState", "a13ee3a330e346c9d87b5aa18d24e11690752bd33a0350f11c5882bc9179260e"},
    {"sensor_msgs/msg/LaserScan", "64c191398013af96509d518dac71d5164f9382553fce5c1f8cca5be7924bd828"},
    {"sensor_msgs/msg/NavSatFix", "62223ab3fe210a15976021da7afddc9e200dc9ec75231c1b6a557fc598a65404"},
    {"std_msgs/msg/Bool", "feb91e995ff9ebd09c0cb3d2aed18b11077585839fb5db80193b62d74528f6c9"},
    {"std_msgs/msg/ColorRGBA", "77a7a5b9ae477306097665106e0413ba74440245b1f3d0c6d6405fe5c7813fe8"},
    {"std_msgs/msg/Empty", "20b625256f32d5dbc0d04fee44f43c41e51c70d3502f84b4a08e7a9c26a96312"},
    {"std_msgs/msg/Float64", "705ba9c3d1a09df43737eb67095534de36fd426c0587779bda2bc51fe790182a"},
    {"std_msgs/msg/Header", "f49fb3ae2cf070f793645ff749683ac6b06203e41c891e17701b1cb597ce6a01"},
    {"std_msgs/msg/String", "df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18"},
    {"std_srvs/srv/Empty_Request", "458eaf200a3f63d9cc53d19436edebc0c140ef4c93ca75d5bd4ce19fd7759e35"},
    {"std_srvs/srv/Empty_Response", "0a2858b3f60df644a61d0fa44cfc923a3d3628e0ad9c8ad8534b1a2c92a413dc"},
    {"std_srvs/srv/SetBool_Request", "c62fbb99d94e1b25e8ef9e109f9581956bb1b3361a45a4e5810c36a90d29932e"},
    {"std_srvs/srv/SetBool_Response", "d0814e7f7b4880ab77e9c57426c7aa1562ab69f11eef8e2e968812f9cbd0b059"},
    {"std_srvs/srv/Trigger_Request", "d010825374ce8918e72bfd826c82603e60f45419e932ea976f807b74a863a199"},
    {"std_srvs/srv/Trigger_Response", "2d946c21e2fc3f1e9ca6986a8191d85fcc70097a8bb7771a053564bc47009cdf"},
    {"tf2_msgs/msg/TFMessage", "e369d0f05a23ae52508854b66f6aa0437f3449d652e8cbf22d5abe85d020f087"},
    {"unique_identifier_msgs/msg/UUID", "1b8e8aca958cbea28fe6ef60bf6c19b683c97a9ef60bb34752067d0f2f7ab437"},
    {"visualization_msgs/msg/Marker", "45b13ccf791f225962bf74e746f9644518855d783a6f42ba0cc14fde2b4f3ce0"},
    {"visualization_msgs/msg/MarkerArray",
     "86cb8800b6fb05b5eff1abd7a56f62a5641d3ae9a1c29e78e67e704f1d067dcf"},
};

TEST(TypeHash, OfEveryTypeEqualsJazzys) {
  for (const Row& row : kJazzy) {
    const TypeDescription* type = find_type(row.ros_name);
    ASSERT_NE(type, nullptr) << row.ros_name;
    EXPECT_EQ(type->type_hash, std::string("RIHS01_") + row.hash) << row.ros_name;
  }
}

std::string hash_of(const std::string& idl, const std::string& ros_name) {
  const idl::Types types = idl::link({idl::parse(idl, "test.idl")});
  return idl::type_hash(types.at(ros_name), types);
}

TEST(TypeHash, OfBoundedStringsAndArrays) {
  EXPECT_EQ(hash_of(R"(
    module rmw_dds_common { module msg {
      struct Gid { uint8 data[16]; };
      struct NodeEntitiesInfo {
        string<256> node_namespace;
        string<256> node_name;
        sequence<rmw_dds_common::msg::Gid> reader_gid_seq;
        sequence<rmw_dds_common::msg::Gid> writer_gid_seq;
      };
      struct ParticipantEntitiesInfo {
        rmw_dds_common::msg::Gid gid;
        sequence<rmw_dds_common::msg::NodeEntitiesInfo> node_entities_info_seq;
      };
    }; };)",
                    "rmw_dds_common/msg/ParticipantEntitiesInfo"),
            "RIHS01_91a0593bacdcc50ea9bdcf849a938b128412cc1ea821245c663bcd26f83c295e");
}

}  // namespace
}  // namespace bw::test
