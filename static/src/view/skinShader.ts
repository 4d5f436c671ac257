/**
 * Skins on the GPU by matrices or by dual quaternions, in every material of the page, for shadows and wire too.
 * Each instance finds its pose, matrices and morph weights, in a texture (`poseTexture.ts`), from the texel
 * `poseStart` on.
 *
 * A vertex follows up to eight matrices, the heaviest first. Without `moreWeights` it follows four: WebGL then
 * reads 0 0 0 1, and the last of eight falling weights is never 1.
 *
 * A matrix ends with the row 0 0 0 1, which is not needed. For dual quaternions its rotation stands there. Each bone carries a vertex to y and turns it by q; the dual quaternions q + ε·½·y·q
 * are blended, as `skin/dual_palette.py` explains. With 0 0 0 1, which is no rotation, this is the blend of
 * the matrices.
 *
 * With the define `OWN_WEIGHTS` a skinned mesh has its morph weights itself, as three's own meshes do.
 */

import * as THREE from "three";

const FUNCTIONS = /* glsl */ `
#ifdef USE_SKINNING
  attribute float poseStart;
  attribute vec4 moreJoints;
  attribute vec4 moreWeights;
  uniform highp sampler2D boneTexture;

  vec4 poseTexel( const in int texel ) {
    int at = int( poseStart ) + texel;
    int width = textureSize( boneTexture, 0 ).x;
    return texelFetch( boneTexture, ivec2( at % width, at / width ), 0 );
  }
  int boneCount() {
    ivec4 first = ivec4( greaterThan( skinWeight, vec4( 0.0 ) ) );
    ivec4 more = ivec4( greaterThan( moreWeights, vec4( 0.0 ) ) ) * int( moreWeights.w < 1.0 );
    return max( 1, first.x + first.y + first.z + first.w + more.x + more.y + more.z + more.w );
  }
  float boneWeight( const in int k ) {
    return k < 4 ? skinWeight[ k ] : moreWeights[ k - 4 ];
  }
  mat4 boneMatrix( const in int k ) {
    int at = int( poseStart ) + 4 * int( k < 4 ? skinIndex[ k ] : moreJoints[ k - 4 ] );
    int width = textureSize( boneTexture, 0 ).x;
    ivec2 place = ivec2( at % width, at / width );
    return mat4(
      texelFetch( boneTexture, place, 0 ),
      texelFetch( boneTexture, place + ivec2( 1, 0 ), 0 ),
      texelFetch( boneTexture, place + ivec2( 2, 0 ), 0 ),
      texelFetch( boneTexture, place + ivec2( 3, 0 ), 0 )
    );
  }
  #if defined( USE_MORPHTARGETS ) && ! defined( OWN_WEIGHTS )
    float morphWeight( const in int target ) {
      int at = int( morphTargetInfluences[ target ] );
      return poseTexel( at / 4 )[ at % 4 ];
    }
  #endif

  vec4 boneTurn( const in mat4 bone ) {
    return vec4( bone[ 0 ].w, bone[ 1 ].w, bone[ 2 ].w, bone[ 3 ].w );
  }
  vec4 nearTo( const in vec4 turn, const in vec4 heaviest ) {
    return dot( turn, heaviest ) < 0.0 ? - turn : turn;
  }
  vec4 carried( const in mat4 bone, const in vec4 turn, const in vec4 vertex ) {
    vec3 y = ( bone * vertex ).xyz;
    return vec4( turn.w * y + cross( y, turn.xyz ), - dot( y, turn.xyz ) );
  }
  vec3 turned( const in vec4 turn, const in vec3 direction ) {
    return direction + 2.0 * cross( turn.xyz, cross( turn.xyz, direction ) + turn.w * direction );
  }
  mat3 stretchOf( const in mat4 bone, const in vec4 turn ) {
    vec4 back = vec4( - turn.xyz, turn.w );
    return mat3( turned( back, bone[ 0 ].xyz ), turned( back, bone[ 1 ].xyz ), turned( back, bone[ 2 ].xyz ) );
  }
  // A normal goes under the inverse transpose, here times the size of the determinant.
  vec3 normalUnder( const in mat3 m, const in vec3 normal ) {
    vec3 x = cross( m[ 1 ], m[ 2 ] );
    vec3 moved = mat3( x, cross( m[ 2 ], m[ 0 ] ), cross( m[ 0 ], m[ 1 ] ) ) * normal;
    if ( dot( moved, moved ) == 0.0 ) return normal;
    return dot( x, m[ 0 ] ) < 0.0 ? - moved : moved;
  }
#endif
`;

// Loops, as software renderers do both sides of a branch.
const BONES = /* glsl */ `
#ifdef USE_SKINNING
  int bones = boneCount();
  mat4 skinMatrix = mat4( 0.0 );
  vec4 heaviest = vec4( 0.0 );
  vec4 skinTurn = vec4( 0.0 );
  bool isTurned = false;
  for ( int k = 0; k < bones; k ++ ) {
    mat4 bone = boneMatrix( k );
    vec4 turn = boneTurn( bone );
    if ( k == 0 ) heaviest = turn;
    skinMatrix += boneWeight( k ) * bone;
    skinTurn += boneWeight( k ) * nearTo( turn, heaviest );
    isTurned = isTurned || dot( turn.xyz, turn.xyz ) > 0.0;
  }
  float skinTurnSquare = dot( skinTurn, skinTurn );
  int turnedBones = isTurned ? bones : 0;
#endif
`;

const NORMALS = /* glsl */ `
#ifdef USE_SKINNING
  mat3 skinStretch = isTurned ? mat3( 0.0 ) : mat3( skinMatrix );
  for ( int k = 0; k < turnedBones; k ++ ) {
    mat4 bone = boneMatrix( k );
    skinStretch += boneWeight( k ) * stretchOf( bone, boneTurn( bone ) );
  }
  vec4 skinTurnUnit = isTurned ? skinTurn * inversesqrt( skinTurnSquare ) : vec4( 0.0, 0.0, 0.0, 1.0 );
  objectNormal = turned( skinTurnUnit, normalUnder( skinStretch, objectNormal ) );
  #ifdef USE_TANGENT
    objectTangent = turned( skinTurnUnit, skinStretch * objectTangent );
  #endif
#endif
`;

const POINTS = /* glsl */ `
#ifdef USE_SKINNING
  vec4 skinVertex = vec4( transformed, 1.0 );
  transformed = ( skinMatrix * skinVertex ).xyz;
  vec4 skinDual = vec4( 0.0 );
  for ( int k = 0; k < turnedBones; k ++ ) {
    mat4 bone = boneMatrix( k );
    skinDual += boneWeight( k ) * carried( bone, nearTo( boneTurn( bone ), heaviest ), skinVertex );
  }
  vec3 skinned = skinTurn.w * skinDual.xyz - skinDual.w * skinTurn.xyz + cross( skinTurn.xyz, skinDual.xyz );
  if ( isTurned ) transformed = skinned / skinTurnSquare;
#endif
`;

const PLAIN_MORPH = /* glsl */ `
#if defined( USE_MORPHTARGETS ) && ( ! defined( USE_SKINNING ) || defined( OWN_WEIGHTS ) )
  float morphWeight( const in int target ) {
    return morphTargetInfluences[ target ];
  }
#endif
`;

/** Makes every material skin in this way; call it before anything is drawn. */
export function teachSkinning(): void {
  const chunks = THREE.ShaderChunk;
  chunks.skinning_pars_vertex = FUNCTIONS;
  chunks.skinbase_vertex = BONES;
  chunks.skinnormal_vertex = NORMALS;
  chunks.skinning_vertex = POINTS;
  chunks.morphtarget_pars_vertex += PLAIN_MORPH;
  for (const name of ["morphcolor_vertex", "morphnormal_vertex", "morphtarget_vertex"] as const)
    chunks[name] = chunks[name].replaceAll("morphTargetInfluences[ i ]", "morphWeight( i )");
  // three's points have no skin.
  const { points } = THREE.ShaderLib;
  points.vertexShader = points.vertexShader
    .replace("#include <morphtarget_pars_vertex>", "$&\n#include <skinning_pars_vertex>")
    .replace("#include <morphtarget_vertex>", "$&\n#include <skinbase_vertex>\n#include <skinning_vertex>");
}
