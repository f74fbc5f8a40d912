# Writes the contract headers as a C++ list of {name, text}: cmake -DINCLUDE=folder -DOUTPUT=file -P embed_contract.cmake
file(GLOB headers RELATIVE ${INCLUDE} ${INCLUDE}/eikonal/*.h)
list(SORT headers)
set(literals "")
foreach(header ${headers})
    file(READ "${INCLUDE}/${header}" text)
    string(APPEND literals "{\"${header}\", R\"contract(${text})contract\"},\n")
endforeach()
file(WRITE "${OUTPUT}" "${literals}")
