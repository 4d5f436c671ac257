"""A .x file made by hand: an arm of two bones in a sleeve, in DirectX's left-handed convention with rows as
vectors, and the second source's IKchain.
"""

IDENTITY = "1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1;;"


def moved(x, y, z):
    """A matrix that moves by x y z."""
    return f"1,0,0,0, 0,1,0,0, 0,0,1,0, {x},{y},{z},1;;"


TURN_ABOUT_X = "1,0,0,0, 0,0,1,0, 0,-1,0,0, 0,1,2,1"
"""y goes to z; at 0 1 2"""
HALF = 0.70710678
ARM = f"""xof 0303txt 0032
// a comment, with a brace }} and a "quote
template IKchain {{ <5b1f2c9e-7a64-4d0b-9c3e-2f8d61a7b045> [Frame <3D82AB46-62DA-11CF-AB39-0020AF71E433>] }}
AnimTicksPerSecond {{ 10; }}
Material Skin {{ 0.5;0.25;1;1;; 6;  1;1;1;; 0;0.5;0;;  TextureFilename {{ "skin // not a comment.png"; }} }}
Frame Root {{
  FrameTransformMatrix {{ {IDENTITY} }}
  Mesh Sleeve {{
    4; 0;0;0;, 1;0;0;, 1;3;2;, 0;3;2;;   # a quad that runs clockwise, seen from the front
    1; 4; 3,2,1,0;;
    MeshNormals {{ 1; 0;0;-2;; 1; 4; 0,0,0,0;; }}
    MeshTextureCoords {{ 4; 0;1;, 1;1;, 1;0;, 0;0;; }}
    MeshMaterialList {{ 1; 1; 0; {{ Skin }} }}
    XSkinMeshHeader {{ 2; 4; 2; }}
    SkinWeights {{ "Arm"; 4; 0,1,2,3; 1,1,0.5,0.25; {moved(0, -1, -2)} }}
    SkinWeights {{ "Hand"; 2; 2,3; 0.5,0.75; {moved(0, -2, -2)} }}
  }}
  Frame Arm {{
    FrameTransformMatrix {{ {moved(0, 1, 2)} }}
    Frame Hand {{ FrameTransformMatrix {{ {moved(0, 1, 0)} }} }}
  }}
}}
AnimationSet Bend {{
  Animation {{ {{ Arm }}
    AnimationKey {{ 0; 2; 0;4; 1,0,0,0;;, 10;4; {HALF},-{HALF},0,0;;; }}
    AnimationKey {{ 2; 1; 0;3; 0,1,2;;; }}
  }}
}}
AnimationSet Turn {{
  Animation {{ {{ Arm }} AnimationOptions {{ 0; 1; }}
    AnimationKey {{ 4; 1; 20;16; {TURN_ABOUT_X};;; }}
  }}
}}
IKchain Reach {{ {{Root}} {{Hand}} }}
"""
LISTING_7_AND_8 = f"""xof 0302txt 0032
template IKchain {{
Frame
// any number of Frame objects can become a
// child of an IKchain. These objects must be
// specified by reference
}}
Mesh parent_mesh {{ 3; 0;0;0;, 1;0;0;, 0;1;0;; 1; 3;0,2,1;; }}
Mesh child_mesh {{ 3; 0;0;1;, 1;0;1;, 0;1;1;; 1; 3;0,2,1;; }}
FrameTransformMatrix parent_matrix {{ {moved(1, 0, 0)} }}
FrameTransformMatrix child_matrix {{ {moved(0, 2, 0)} }}
Frame Object_Root {{
    {{parent_mesh}}
    {{parent_matrix}}

    Frame Object_Child {{
        {{child_mesh}}
        {{child_matrix}}
    }}
}}
// example
IKchain MyIK {{
    {{Object_Root}}
    {{Object_Child}}
}}
"""
"""the listings of the second source (3.2), with the objects that they assume"""
